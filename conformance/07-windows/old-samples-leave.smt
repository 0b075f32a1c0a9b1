spec 7.6  After n steps a sample has left the window: the maximum of the last three.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[Run]
.step
    x = roll_max(p, 3)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 5
G == 1: p = 1
G == 2: p = 2
G == 3: p = 0
G == 4: p = 7
G == 5: p = 3
G == 6: p = 3
G == 7: p = 3
G == 0: @assert x == 5
G == 1: @assert x == 5
G == 2: @assert x == 5
G == 3: @assert x == 2
G == 4: @assert x == 7
G == 5: @assert x == 7
G == 6: @assert x == 7
G == 7: @assert x == 3
G == 7: @stop
