spec 10.7   An option appears once.

-- rocket.app --
[options]
state_vector "rocket.sv"
events 8
events 16     #! E1022 duplicate 'events'
[flight]
every 10 ms:
    task navigation
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
