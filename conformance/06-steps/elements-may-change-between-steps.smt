spec 6.15  The machine reads the values from outside, and its own assignments only until they are overwritten.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[Run]
.step
    x = p
    p = p + 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 10
G == 1: @assert x == 11
G == 2: p = 50
G == 2: @assert x == 50 and p == 51
G == 3: @assert x == 51
G == 3: @stop
