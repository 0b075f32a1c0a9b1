spec 10.11   A task must follow a rate.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]
    task a                    #! E1025 every 10 ms:
    task b
every 10 ms:
    task c
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
