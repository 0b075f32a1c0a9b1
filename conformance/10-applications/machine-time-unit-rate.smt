spec 5.60   A machine with a rate counts the application's unit, too; one without any time does not.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 100 us
[flight]
every 10 ms:
    machine mission "mission.sm"     #! E1057 machine 'mission' counts time in ms, but the application in units of 100 us
    machine other "other.sm" { state = otherState }
-- rocket.sv --
[A]
U64  time
U32  missionState
U32  otherState
F64  altitude
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only

[Boost]
.step
    rate(altitude, 3 steps) < 0: -> Coast
[Coast]
-- other.sm --
[state_vector]
U64  time      @alias G
U32  state     @alias S
F64  altitude  @read_only

[Boost]
.step
    prev(altitude) > altitude: -> Coast
[Coast]
