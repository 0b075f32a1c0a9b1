spec 10.13   With several executors the state vector must contain lock.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]
every 10 ms:
    task navigation
[slow]                #! E1038 write 'lock' under [options] in rocket.sv
every 1 s:
    task b
-- rocket.sv --
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
