spec 7.23, 7.25  A window of 40 ms has three samples where a step is 20 ms.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
F64 b
F64 c
F64 d
F64 e
[options]
step 20 ms
[define]
short = 0.04 s
same = short
n = 3
[local]
U32 m = 3 @read_only
[Run]
.step
    a = roll_avg(p, 40 ms)
    b = roll_avg(p, (same))
    c = roll_avg(p, 3 steps)
    d = roll_avg(p, n steps) + roll_avg(p, m steps)
    e = roll_avg(p, 0 s)

-- app.ss --
[define]
mean = roll_avg(p, 20 ms)
[all_states]
true: p = G * G
G == 100 ms {
    @assert a == (100 * 100 + 80 * 80 + 60 * 60) / 3
    @assert a == b and b == c and d == 2 * a
    @assert e == p
    @assert mean == (80 * 80 + 60 * 60) / 2
    @stop
}
