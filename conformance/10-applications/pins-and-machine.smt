spec 10.18   An input into an element that a machine writes is a warning.

-- rocket.app --
[options]
state_vector "rocket.sv"
io "rocket.io"
time time 1 ms
[flight]
every 10 ms:
    inputs
    outputs
    machine mission "mission.sm"
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
-- rocket.io --
[analog]
i 0 target     #! W1190 mission
o 1 target
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
F64  target
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
.step
    target = 1
