spec 7.12  The sum of 1e16, 1, -1e16, 1 in pairs is 0; in order it would be 1.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[Run]
.step
    x = roll_avg(p, 4)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1e16
G == 1: p = 1
G == 2: p = -1e16
G == 3: p = 1
G == 3: @assert x == (1e16 + 1 + (-1e16 + 1)) / 4
G == 3: @stop
