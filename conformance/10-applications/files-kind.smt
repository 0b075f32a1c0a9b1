spec 10.1, 10.2, 10.15   Files have the extension of their kind.

-- rocket.app --
[options]
state_vector "mission.sm"     #! E1032 .sv
io "rocket.sv"     #! E1032 .io
time time 1 ms
[flight]
every 10 ms:
    machine mission "rocket.io"     #! E1032 .sm
    inputs
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
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
-- rocket.io --
[analog]
i 0 altitude
o 1 target
