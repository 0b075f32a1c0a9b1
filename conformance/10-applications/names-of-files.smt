spec 10.17   Two files of an application are not called alike in C.

-- rocket.app --
[options]
state_vector "rocket.sv"
io "ROCKET_app.io"
time time 1 ms
[flight]
every 10 ms:
    machine a "rocket.sm"             #! E1043 rocket.c
    machine b "rocket_APP.sm"         #! E1043 the application
    machine c "mission.sm"
    inputs
    outputs
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
-- rocket.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
-- rocket_APP.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
-- ROCKET_app.io --
[analog]
i 0 altitude
o 1 target
