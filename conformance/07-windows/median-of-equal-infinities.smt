spec 7.16  Two equal infinities in the middle are their own median.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[Run]
.step
    x = roll_median(p, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
true: p = 1/0
true: @assert x == 1/0
G == 2: @stop
