spec 10.18   Nor is the time an input.

-- rocket.app --
[options]
state_vector "rocket.sv"
io "rocket.io"
time time 1 ms                        #! W1041 an input
[flight]
every 10 ms:
    inputs
    outputs
    task a
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
i 0 time
o 1 target
