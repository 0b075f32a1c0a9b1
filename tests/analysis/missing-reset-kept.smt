# A lock with one companion; a latch that decides alone and is kept over attempts; one that lasts from the first phase of a run to its end.
warn no-all missing-reset

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
bool go @read_only @command
bool valve
[local]
bool locked = false
bool seen = false
bool slow = false
bool hot = false
bool high = false
bool leak = false
[Idle] @safe
.entry
    valve = false
.step
    go and not locked {
        hot = false
        high = false
        leak = false
        slow = false
        -> First
    }
    go and T > 900 {
        hot = false
        high = false
        leak = false
        -> First
    }
[First]
.entry
    valve = true
.step
    p > 2: slow = true
    p > 5: hot = true
    p > 6: high = true
    p > 7: leak = true
    hot or high or leak: -> Wait
    T > 50 and slow: -> Second
[Wait]
.step
    T > 20 {
        high = false
        leak = false
        -> Second
    }
[Second]
.step
    p > 5: hot = true
    p > 6: high = true
    p > 7: leak = true
    hot and high or leak: -> Last
    T > 50: -> Last
[Last]
.entry
    seen = false
.step
    p > 8: locked = true
    p > 9: seen = true
    locked and seen: -> Idle
    T > 90: -> Idle
