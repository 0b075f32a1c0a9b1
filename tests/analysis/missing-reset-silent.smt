# Values that are reset on every way back, on the next entry or by an operator; the best of several attempts; what no guard reads.
warn no-all missing-reset

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
bool go @read_only @command
bool clear @read_only @command
bool valve
F32 record
[local]
F32  best = 0
F32  now = 0
bool hot = false
bool high = false
bool leak = false
bool lock = false
bool seen = false
bool tried = false
[all_states]
.step
    clear: lock = false
[Idle] @safe
.entry
    valve = false
    hot = false
    high = false
    leak = false
    lock = false
.step
    go {
        best = 0
        -> Try
    }
[Try]
.entry
    valve = true
    tried = true
    now = 0
    seen = false
.step
    now = max(now, p)
    best = max(best, p)
    record = max(record, p)
    p > 4: seen = true
    p > 5: hot = true
    p > 6: high = true
    p > 7: leak = true
    p > 8: lock = true
    hot or high or leak or lock: -> Idle
    seen and p < now - 1 and p < best - 1 {
        hot = false
        high = false
        -> Pause
    }
[Pause]
.step
    T > 20 and not seen and tried: -> Idle
    T > 30 {
        hot = false
        high = false
        leak = false
        -> Try
    }
