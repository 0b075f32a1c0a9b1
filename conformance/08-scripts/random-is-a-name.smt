spec 8.48  Elements and variables can be called random and noise.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 random
[A]
.step
    x = p
    T == 30: -> Burn
[Burn]
.step
    x = p + 1000
-- app.ss --
[options]
delta_t 10
[local]
F64 noise = 5
[all_states]
at 0: random = noise
true: p = random + noise(0) + random(1, 1)
at 0: @assert x == 6 and random == 5 and noise == 5
at 10: @stop
