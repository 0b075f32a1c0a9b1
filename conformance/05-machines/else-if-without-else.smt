spec 5.35  Without a last else nothing is executed when no guard is true.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 x

[Run]
.step
    x = 9
    if a > 20: x = 2
    else if a > 10: x = 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: a = 5
G == 0: @assert x == 9
G == 1: a = 15
G == 1: @assert x == 1
G == 2: a = 25
G == 2: @assert x == 2
G == 2: @stop
