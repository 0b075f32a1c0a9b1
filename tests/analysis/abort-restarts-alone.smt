# A thermostat that starts by itself also goes on by itself, and so does one whose command is only one of several reasons to start.
warn no-all abort-restarts

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
bool go @read_only @command
bool pump
bool fan
[Wait] @safe
.step
    p > 5: -> Run
    go or T > 900: -> Blow
[Run]
.entry
    pump = true
.step
    p > 9: -> Stop
[Blow]
.entry
    fan = true
.step
    p > 9: -> Stop
    T > 20: -> Wait
[Stop] @abort
.entry
    pump = false
    fan = false
.step
    p < 3: -> Blow
    p < 7: -> Run
