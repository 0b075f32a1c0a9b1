spec 10.1   A section of options under another name is reported as such.

-- rocket.app --
[option]     #! E1048 [options]
state_vector "rocket.sv"
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
