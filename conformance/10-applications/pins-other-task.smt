spec 10.13   Pins that are read need the task that reads them, those that are set the one that sets them.

-- rocket.app --
[options]
state_vector "rocket.sv"
io "rocket.io"               #! W1044 outputs
[flight]
every 10 ms:
    inputs
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
F64  target
-- rocket.io --
[analog]
i 0 altitude
o 1 target
