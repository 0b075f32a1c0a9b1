# A transition out of the @abort state that a dead sensor triggers.
warn no-all abort-exit

-- app.sm --
[state_vector]
U64  G
U32  S
F32  p     @read_only
bool reset @read_only
bool valve
[Idle] @safe
.step
    T > 100: -> Open
[Open]
.entry
    valve = true
.step
    p > 50: -> Abort
    T > 1000: -> Idle
.exit
    valve = false
[Abort] @abort @safe
.step
    T > 5000 and p < 2: -> Idle       #! W0906 'p' alone ends the @abort state 'Abort' when it reads 0
    reset: -> Idle
