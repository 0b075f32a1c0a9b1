spec 10.6   What the application writes is not one file twice, and no source.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
log "./mission.sm" 4 KB      #! E1052 a machine's
keep "rocket.sv"             #! E1052 the state vector's
[flight]
every 10 ms:
    machine mission "mission.sm"
    log
    keep
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
F64  target
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
