spec 10.17   Files that would be called like the runtime are refused.

-- rocket.app --
[options]
state_vector "sm.sv"     #! E1046 runtime
[flight]
every 10 ms:
    task pal_x     #! E1046 runtime
-- sm.sv --
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
