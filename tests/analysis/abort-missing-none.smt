# Without a state marked @abort nothing is asked about aborting.
warn no-all abort-missing abort-by-command
-- app.sm --
[state_vector]
U64  G
U32  S
bool go @read_only @command
bool valve
[Idle] @safe
.step
    go: -> Fill
[Fill]
.entry
    valve = true
.step
    T > 3000: -> Idle
.exit
    valve = false
