spec 10.17   Files that only begin with the same letters are not.

-- rocket.app --
[options]
state_vector "SMOKE.sv"
[flight]
every 10 ms:
    task small
-- SMOKE.sv --
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
