spec 7.5  Calls may be composed: the outer window samples the inner one as it is in the same step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y
F64 z

[Run]
.step
    x = roll_max(roll_min(p, 2), 3)
    y = roll_avg(roll_avg(p, 2), 2)
    z = roll_range(p - roll_avg(p, 2), 2)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 4
G == 1: p = 8
G == 2: p = 2
G == 3: p = 6
G == 0: @assert x == 4 and y == 4 and z == 0
G == 1: @assert x == 4 and y == 5 and z == 2
G == 2: @assert x == 4 and y == 5.5 and z == 5
G == 3: @assert x == 4 and y == 4.5 and z == 5
G == 3: @stop
