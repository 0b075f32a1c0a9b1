spec 7.4, 7.10  An assignment of the same step does not reach a window, however often it is asked.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 z

[local]
F64 k = 1

[Run]
.step
    x = roll_max(k, 5)
    k = k * 2
    y = roll_max(k, 5)
    z = roll_range(k * 2, 5)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 1 and y == 1 and k == 2 and z == 0
G == 1: @assert x == 2 and y == 2 and k == 4 and z == 2
G == 2: @assert x == 4 and y == 4 and z == 6
G == 2: @stop
