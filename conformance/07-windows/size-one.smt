spec 7.2, 7.6  A window of size 1 contains the newest sample.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
F64 b
F64 m
F64 r

[Run]
.step
    a = roll_avg(p, 1)
    b = roll_median(p, 1)
    m = roll_min(p, 1) + roll_max(p, 1)
    r = roll_range(p, 1)

-- app.ss --
[options]
delta_t 1

[all_states]
true: p = G * G
true: @assert a == G * G and b == a and m == 2 * a and r == 0
G == 5: @stop
