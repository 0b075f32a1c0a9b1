spec 10.13   Where pins are only set, or only read, one task is enough.

-- rocket.app --
[options]
state_vector "rocket.sv"
io "rocket.io"
[flight]
every 10 ms:
    outputs
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
-- rocket.io --
[analog]
o 1 target
