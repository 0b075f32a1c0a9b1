spec 10.17   Files that would be called like the runtime are refused, in whatever letters.

-- rocket.app --
[options]
state_vector "SmApp.sv"     #! E1046 runtime
[flight]
every 10 ms:
    task x
-- SmApp.sv --
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
