spec 7.33  Without a step in [options], a warning says that gaps count as held.
warn

-- app.sm --
[state_vector]
U64  G
U32  S
F64  p
bool a
[define]
high = p > 3
[Run]
.step
    a = held(p > 1, 20 ms)                 #! W0425 in [options] add 'step', as in: step 20 ms
    a = held(p > 2, 3 steps)               #! W0425 a gap in the data counts as held
    held(high, 20 ms) and a: -> Done       #! W0425
    @allow(held-without-step, "the sensor never stops")
    a = held(p > 5, 1 s)
[Done]
