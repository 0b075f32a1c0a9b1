spec 10.9   An executor has tasks.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]              #! E1030 needs a rate with tasks
[slow]
every 10 ms:          #! E1030 no task
every 20 ms:
    task a
-- rocket.sv --
[options]
lock
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
U8   otherMode
U32  late
U32  busy
F64  target
I16  small
