spec 6.14, 2.13  What is read back is the stored value, not the value that was assigned.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 n
F32 f
bool b
F64 x
F64 y
F64 z
F64 w

[Run]
.step
    n = w * 30.5
    x = n
    f = w / 100
    y = f
    b = w
    z = b + b

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: w = 10
G == 0: @assert x == 255 and y == 0.10000000149011612 and z == 2
G == 1: w = 3
G == 1: @assert x == 91
G == 1: @stop
