spec 7.2  2.0 and 3e0 are whole numbers, and true is 1.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y
F64 z

[Run]
.step
    x = roll_max(p, 2.0)
    y = roll_max(p, 3e0)
    z = roll_max(p, true)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 9
G == 1: p = 1
G == 2: @assert x == 1 and y == 9 and z == 1
G == 2: @stop
