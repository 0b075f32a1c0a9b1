# Two altimeters must have fallen.
warn no-all output-on-zero

-- app.sm --
[state_vector]
U64  G
U32  S
F32  one @read_only @range -50 12000
F32  two @read_only @range -50 12000
bool drogue
[local]
F64 high1 = 0
F64 high2 = 0
[Ascent]
.step
    high1 = max(high1, one)
    high2 = max(high2, two)
    one < high1 - 10 and two < high2 - 10: -> Drogue
    T > 18000: -> Drogue
[Drogue] @safe
.entry
    drogue = true
.step
    T > 1000: drogue = false
