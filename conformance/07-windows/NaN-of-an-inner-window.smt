spec 7.21, 7.8  The outer window takes the NaN of an inner one as 0.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[Run]
.step
    x = roll_min(roll_avg(p, 2), 1)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1/0
G == 1: p = -1/0
G == 1: @assert x == 0
G == 1: @stop
