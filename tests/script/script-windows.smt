# A script's windows are its own and take their samples before its inputs; asserts see them as they were then.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 m
[Idle]
.step
    m = roll_max(x, 2)
-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: x = 5
G == 1: x = 3
G == 0: @assert roll_max(x, 2) == 0 and m == 5
G == 1: @assert roll_max(x, 2) == 5 and roll_avg(x, 2) == 2.5 and m == 5
G == 2: @assert roll_max(x, 2) == 5 and roll_avg(x, 2) == 4 and m == 3
G == 2: @stop
