spec 10.8   A value that does not fit is a warning.

-- rocket.app --
[options]
state_vector "rocket.sv"
[start]
mode  = 300                  #! W1042 a U8: it will be 255
small = 1.5                  #! W1042 it will be 1
late  = 7
altitude = 0.1
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
