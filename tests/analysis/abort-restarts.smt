# A start after an abort without the command that the first start needs, at once and through another state.
warn no-all abort-restarts

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
bool go @read_only @command
bool pump
bool vent
[Idle] @safe
.step
    T > 5 and go: -> Run
    p > 9: -> Stop
[Run]
.entry
    pump = true
    vent = false
.step
    p > 9: -> Stop
    p > 8: -> Trip
    T > 500: -> Purge
[Purge]
.entry
    pump = false
    vent = true
.step
    T > 20: -> Idle
[Stop] @abort
.entry
    pump = false
    vent = false
.step
    p < 2 and T > 30: -> Run        #! W0913 after 'Stop' the machine switches 'pump' on again in 'Run' without a command
    T > 900: -> Idle
[Trip] @abort
.entry
    pump = false
    vent = true
.step
    p < 2 and T > 30: -> Calm       #! W0913 after 'Trip' the machine switches 'pump' on again in 'Run'
    p < 1: -> Purge
[Calm]
.step
    p > 9: -> Trip
    T > 60: -> Run
