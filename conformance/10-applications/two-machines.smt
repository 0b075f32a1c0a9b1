spec 10.18   Two machines that write one element are a warning.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine mission "mission.sm"
    machine brakes "brakes.sm"
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
U32  brakeState
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
-- brakes.sm --
[state_vector]
U64  time          @alias G
U32  brakeState  @alias S
F64  altitude      @read_only
F64  target
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
.step
    target = 2     #! W0960 mission
