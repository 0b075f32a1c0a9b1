spec 7.17, 7.21  The median of −inf and inf is NaN, as −inf / 2 + inf / 2 is; stored it is 0.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y

[Run]
.step
    x = roll_median(p, 2)
    y = roll_median(p, 2) == roll_median(p, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1/0
G == 1: p = -1/0
G == 1: @assert x == 0 and y == 0
G == 1: @stop
