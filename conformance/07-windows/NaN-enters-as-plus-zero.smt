spec 7.8, 2.12  A NaN becomes +0, whatever its sign.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
F64 b

[Run]
.step
    a = roll_min(-(p / p), 2)
    b = roll_max(p / p, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 1: @assert 1 / a == 1/0 and 1 / b == 1/0
G == 1: @stop
