spec 7.16  The median of 0.1 and 0.7 is 0.1 + (0.7 - 0.1) / 2.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[Run]
.step
    x = roll_median(p, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 0.7
G == 1: p = 0.1
G == 1: @assert x == 0.1 + (0.7 - 0.1) / 2
G == 2: @assert x == 0.1
G == 2: @stop
