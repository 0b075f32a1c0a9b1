spec 10.13   Pins without a task that reads or sets them are a warning.

-- rocket.app --
[options]
state_vector "rocket.sv"
io "rocket.io"     #! W1040 neither
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
-- rocket.io --
[analog]
i 0 altitude
o 1 target
