spec 10.8   [start] appears once.

-- rocket.app --
[options]
state_vector "rocket.sv"
[start]
mode = 1
[start]                      #! E0302 duplicate section [start]
late = 1
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
