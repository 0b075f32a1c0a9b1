spec 10.9   An application has an executor.

-- rocket.app --
[options]     #! E1030 needs an executor
state_vector "rocket.sv"
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
