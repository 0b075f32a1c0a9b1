spec 5.60   A machine with a step shorter than the period of its task is an error, too.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 20 ms:
    machine mission "mission.sm"     #! E1058
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
-- mission.sm --
[options]
step 10 ms
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only

[Boost]
.step
    altitude > 100: -> Coast
[Coast]
