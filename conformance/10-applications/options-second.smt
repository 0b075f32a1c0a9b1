spec 10.1   [options] appears once.

-- rocket.app --
[options]
state_vector "rocket.sv"
[options]      #! E0302 duplicate section [options]
events 8
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
