spec 5.60  A machine with a time counts the application's unit.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 100 us
[flight]
every 10 ms:
    machine mission "mission.sm"     #! E1057 machine 'mission' counts time in ms, but the application in units of 100 us
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only

[Boost]
.step
    altitude > 100: -> Coast
    T > 1 s: -> Coast
[Coast]
