# Switched off by .exit, by the next state, by time, before every way out, or handed over by all of them.
warn no-all exit-leaves-on

-- app.sm --
[state_vector]
U64 G
U32 S
bool go @read_only
bool cancel @read_only
F32 pressure @read_only @range 0 100
bool byExit
bool byNext
bool byTime
bool first
bool handed
bool told
[Idle] @safe
.entry
    byExit = false
    byNext = false
    byTime = false
    first = false
    handed = false
.step
    go: -> Work
[Work]
.entry
    byExit = true
    byNext = true
    byTime = true
    first = true
    handed = true
.step
    first = pressure < 40
    T > 1000: byTime = false
    cancel: -> Vent
    pressure > 52 {
        byExit = false
        byNext = false
        byTime = false
        -> Armed
    }
    T > 9000: -> Vent
.exit
    byExit = false
[Armed]
.step
    cancel: -> Vent
    T > 5000: -> Vent
[Vent]
.entry
    byNext = false
.step
    pressure < 2: -> Idle
