spec 10.12   A period has one group.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]
every 10 ms:
    task a
at 100 Hz:                    #! E1037 10 ms
    task b
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
