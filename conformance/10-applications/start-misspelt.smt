spec 10.8   A section of values under another name is reported as such.

-- rocket.app --
[options]
state_vector "rocket.sv"
[begin]     #! E1048 [start]
mode = 2
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
