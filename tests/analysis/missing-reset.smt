# Latches and extremes of an earlier run. `peak` and `stuck` are never reset, `hot` is missing on one path back.
warn no-all missing-reset

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
bool go @read_only @command
bool valve
F32 best
[local]
F32  peak = 0
F32  top = 0
bool stuck = false
bool hot = false
bool high = false
bool leak = false
bool once = false
bool kept = false
[Idle] @safe
.entry
    valve = false
    top = 0
.step
    go {
        hot = false
        high = false
        leak = false
        -> Run
    }
[Run]
.entry
    valve = true
.step
    top = max(top, p)
    peak = max(peak, p)             #! W0911 'peak' keeps its value in the next run: the machine resets
    best = max(best, p)
    T > 5: once = true
    p > 4: stuck = true             #! W0911 'stuck'
    p > 5: hot = true
    p > 6: high = true
    p > 7: leak = true
    p > 8: kept = true
    hot or high or leak: -> Hold
    stuck and p < peak - 5 and p < top: -> Hold
    once and T > 50: -> Idle
[Hold]
.entry
    valve = false
    once = false
.step
    kept and go: kept = false
    kept: -> Idle
    go and T > 20 {
        high = false                #! W0912 'hot' is not reset here with 'high' and 'leak'
        leak = false
        -> Run
    }
    T > 90: -> Idle
