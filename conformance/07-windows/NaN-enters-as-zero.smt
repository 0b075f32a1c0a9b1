spec 7.8  A sample that is NaN counts as 0, in every statistic.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
F64 b
F64 d
F64 e
F64 f

[Run]
.step
    a = roll_avg(p / p, 4)
    b = roll_median(p / p, 3)
    d = roll_min(p / p, 3)
    e = roll_max(-p / p, 3)
    f = roll_range(p / p, 3)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 0
G == 0: @assert a == 0 and b == 0 and d == 0 and e == 0
G == 1: p = 5
G == 1: @assert a == 0.5 and b == 0.5 and d == 0 and e == 0 and f == 1
G == 3: @assert a == 0.75 and b == 1 and d == 1 and e == -1 and f == 0
G == 3: @stop
