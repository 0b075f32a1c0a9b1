spec 3.33, 6.17  The comparison reads S: in each state it is the number of that state, also in a step that leaves it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
[local]
F64 n = 0
[Idle]
.step
    n = n + 1
    x = S == Idle
    n > 2: -> Run
[Run]
.step
    y = S == Run
    y = y + 2 * (S != 2)

-- app.ss --
[options]
delta_t 1
[all_states]
G == 1: @assert x == 1
G == 4: @assert y == 1
G == 5: @stop
