# A command leads out, or only into a state that is safe; a purge after the abort switches on nothing that the abort has switched off.
warn no-all abort-restarts

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
bool go @read_only @command
bool pump
bool vent
[local]
bool agreed = false
[Idle] @safe
.step
    go: -> Run
[Run]
.entry
    pump = true
.step
    p > 9: -> Stop
    p > 8: -> Trip
    p > 7: -> Shut
    T > 500: -> Purge
[Purge]
.entry
    vent = true
.step
    T > 20: -> Idle
[Stop] @abort
.entry
    pump = false
.step
    go and p < 2: -> Run
    T > 90: -> Purge
[Trip] @abort
.entry
    pump = false
.step
    p < 2: -> Hold
[Hold] @safe
.step
    go: -> Run
[Shut] @abort
.entry
    pump = false
    agreed = false
.step
    go: agreed = true
    agreed and p < 2: -> Run
