spec 3.23  round takes halves away from zero: 0.5 to 1, 2.5 to 3, -2.5 to -3.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  c
F64  d
F64  e
F64  f
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  r6
F64  r7
F64  r8
F64  r9
F64  r10
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6
F64  c7
F64  c8
F64  c9
F64  c10

[local]
F64  ka = 2.5 @read_only
F64  kb = -2.5 @read_only
F64  kc = 0.5 @read_only
F64  kd = 1.5 @read_only
F64  ke = -0.4 @read_only
F64  kf = -0.5 @read_only

[Run]
.step
    r1 = round(a)
    r2 = round(b)
    r3 = round(c)
    r4 = round(d)
    r5 = round(e)
    r6 = round(f)
    r7 = round(3.5)
    r8 = round(-3.5)
    r9 = round(2.4999999999999996)
    r10 = round(0.3)
    c1 = round(ka)
    c2 = round(kb)
    c3 = round(kc)
    c4 = round(kd)
    c5 = round(ke)
    c6 = round(kf)
    c7 = round(3.5)
    c8 = round(-3.5)
    c9 = round(2.4999999999999996)
    c10 = round(0.3)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2.5
    b = -2.5
    c = 0.5
    d = 1.5
    e = -0.4
    f = -0.5
    @assert r1 == 3
    @assert r2 == -3
    @assert r3 == 1
    @assert r4 == 2
    @assert 1 / r5 == -1/0
    @assert r6 == -1
    @assert r7 == 4
    @assert r8 == -4
    @assert r9 == 2
    @assert 1 / r10 == 1/0
    @assert c1 == 3
    @assert c2 == -3
    @assert c3 == 1
    @assert c4 == 2
    @assert 1 / c5 == -1/0
    @assert c6 == -1
    @assert c7 == 4
    @assert c8 == -4
    @assert c9 == 2
    @assert 1 / c10 == 1/0
    @stop
}
