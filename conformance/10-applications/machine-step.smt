spec 5.60  A machine's step is the period of its task.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine mission "mission.sm"     #! E1058 machine 'mission' declares a step of 20 ms, but runs every 10 ms
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
[options]
step 20 ms

[Boost]
.step
    altitude > 100: -> Coast

[Coast]
