spec 7.1, 5.11  A local counts with its stored initial value: 2.9 in a U8 is 2.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[local]
U8 n = 2.9

[Run]
.step
    x = roll_max(p, n)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 9
G == 1: p = 1
G == 1: @assert x == 9
G == 2: @assert x == 1
G == 2: @stop
