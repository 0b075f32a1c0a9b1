spec 3.23  The largest F64 below a half rounds down, and large odd numbers stay: adding 0.5 first would go wrong.

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
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6

[local]
F64  ka = 0.49999999999999994 @read_only
F64  kb = 4503599627370497 @read_only
F64  kc = 4503599627370495.5 @read_only
F64  kd = 9007199254740991 @read_only
F64  ke = -0.49999999999999994 @read_only
F64  kf = 4503599627370494.5 @read_only

[Run]
.step
    r1 = round(a)
    r2 = round(b)
    r3 = round(c)
    r4 = round(d)
    r5 = round(e)
    r6 = round(f)
    c1 = round(ka)
    c2 = round(kb)
    c3 = round(kc)
    c4 = round(kd)
    c5 = round(ke)
    c6 = round(kf)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0.49999999999999994
    b = 4503599627370497
    c = 4503599627370495.5
    d = 9007199254740991
    e = -0.49999999999999994
    f = 4503599627370494.5
    @assert 1 / r1 == 1/0
    @assert r2 == 4503599627370497.0
    @assert r3 == 4503599627370496.0
    @assert r4 == 9007199254740991.0
    @assert 1 / r5 == -1/0
    @assert r6 == 4503599627370495.0
    @assert 1 / c1 == 1/0
    @assert c2 == 4503599627370497.0
    @assert c3 == 4503599627370496.0
    @assert c4 == 9007199254740991.0
    @assert 1 / c5 == -1/0
    @assert c6 == 4503599627370495.0
    @stop
}
