spec 10.17   Files that would be called like the runtime are refused, in whatever letters.

-- rocket.app --
[options]
state_vector "SM.sv"     #! E1046 runtime
[flight]
every 10 ms:
    task x
-- SM.sv --
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
