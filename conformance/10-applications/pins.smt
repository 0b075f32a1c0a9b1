spec 10.2   Pins are inputs and outputs of the application.

-- rocket.app --
[options]
state_vector "rocket.sv"
io "rocket.io"
[flight]
every 10 ms:
    inputs
    outputs @mode mode
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
i 0 altitude
o 1 target
