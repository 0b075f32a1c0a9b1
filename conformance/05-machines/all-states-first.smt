spec 5.21, 5.68, 5.69  [all_states] may be the first section of a file, and may follow the states.

-- app.sm --
[all_states]
.step
    x = x + 1
[state_vector]
U64 G
U32 S
F64 x
F64 y
[Run]
.step
    y = x
[all_states]
.step
    x = x + 10
-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: @assert x == 11 and y == 11
G == 1: @assert x == 22 and y == 22
G == 1: @stop
