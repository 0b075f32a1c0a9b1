# One flight without a way back: the extreme belongs to the whole flight, others to one phase.
warn no-all missing-reset

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
bool chute
[local]
F32  peak = 0
F32  last = 0
bool fell = false
[Pad] @safe
.step
    p > 5: -> Rise
[Rise]
.entry
    last = 0
    fell = false
.step
    peak = max(peak, p)
    last = max(last, p)
    T > 5: fell = true
    p < peak - 3: -> Check
[Check]
.step
    p > last: -> Rise
    fell and T > 40: -> Down
[Down] @safe
.entry
    chute = true
