spec 7.7, 7.9  The first average is the first sample itself, not a fraction of it.

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
    x = roll_avg(p, 100)
    y = roll_min(p, 100)
    z = roll_median(p, 100)

-- app.ss --
[options]
delta_t 1

[all_states]
true: p = 6 + G
G == 0: @assert x == 6 and y == 6 and z == 6
G == 1: @assert x == 6.5 and y == 6 and z == 6.5
G == 1: @stop
