spec 7.3  A local that the machine assigns is accepted with a warning, and the window keeps its size.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[local]
U8 n = 2

[Run]
.step
    x = roll_max(p, n)   #! W0402
    n = 5

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 9
G == 1: p = 1
G == 1: @assert x == 9
G == 2: @assert x == 1 and n == 5
G == 2: @stop
