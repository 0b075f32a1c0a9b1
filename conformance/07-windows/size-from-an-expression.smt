spec 7.1  The size may be an expression of numbers, locals and pure functions.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y
F64 z

[local]
U8 n = 2 @read_only
F64 half = 0.5 @read_only

[Run]
.step
    x = roll_max(p, n + 1)
    y = roll_max(p, 1 / half)
    z = roll_max(p, max(1, floor(3.7)) - n)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 9
G == 1: p = 1
G == 2: p = 2
G == 2: @assert x == 9 and y == 2 and z == 2
G == 3: p = 0
G == 3: @assert x == 2 and y == 2 and z == 0
G == 3: @stop
