spec 10.16   With -Wflight a task that can be safed needs @safe; a machine that writes only S has no outputs to make safe.
warn flight

-- rocket.app --
[options]
state_vector "rocket.sv"
time         time 1 ms
io           "rocket.io"
log          "flight.log" 4 KB
[flight]
every 10 ms:
    task    navigation
    task    engine    @mode mode @safe
    task    parachute @mode mode            #! W1045 'parachute' has a mode and no @safe
    machine mission "mission.sm" @mode mode #! W1045 'mission' has a mode and is a machine: while safed, it does not step, and 'valve' stays as it is
    machine phase   "phase.sm" @mode mode
    machine free    "free.sm"
    outputs @mode mode
    log     @mode mode
-- rocket.io --
[digital]
o 9 valve
-- rocket.sv --
[A]
U64  time
U32  missionState
U32  phaseState
U32  freeState
U8   mode
bool valve
bool other
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
bool valve
[Boost] @safe
.step
    T > 100: valve = false
-- phase.sm --
[state_vector]
U64  time          @alias G
U32  phaseState    @alias S
[A]
.step
    T > 100: -> B
[B] @safe
-- free.sm --
[state_vector]
U64  time          @alias G
U32  freeState     @alias S
bool other
[A] @safe
.step
    other = T > 100
