spec 2.9  The statements after a division by zero are executed, and so are the steps after it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
U8 n
I32 k

[Run]
.step
    x = y / (T * 0)
    k = 0 / y
    n = n + 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: y = 0
G == 1: y = -3
G == 1: @assert x == -1/0
G == 2: @assert n == 3 and x == -1/0
G == 2: @stop
