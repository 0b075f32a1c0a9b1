# Accepted at the declaration: of what is not reset, and of the output that starts again.
warn no-all missing-reset abort-restarts

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
bool go @read_only @command
bool pump @allow(abort-restarts, "the pump cools the bearing, and starts again by itself")
[local]
F32 top = 0
F32 peak = 0 @allow(missing-reset, "the highest pressure of the pump's life")
[Idle] @safe
.entry
    top = 0
.step
    go: -> Run
[Run]
.entry
    pump = true
.step
    top = max(top, p)
    peak = max(peak, p)
    top > 9 or peak > 99: -> Stop
[Stop] @abort
.entry
    pump = false
.step
    p < 2: -> Run
    go: -> Idle
