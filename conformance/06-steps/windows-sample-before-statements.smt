spec 6.6, 7.4  A window takes its sample before .entry and .step: their assignments are sampled in the next step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[A]
.entry
    p = 50
.step
    x = roll_max(p, 2)
    p = p + 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 0 and p == 51
G == 1: @assert x == 51
G == 2: @assert x == 52
G == 2: @stop
