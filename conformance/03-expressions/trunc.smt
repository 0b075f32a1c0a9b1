spec 3.22  trunc goes toward zero and keeps the sign of zero.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  h
F64  t
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
F64  ka = 2.75 @read_only
F64  kb = -2.75 @read_only
F64  kh = -0.5 @read_only
F64  kt = -5e-324 @read_only

[Run]
.step
    r1 = trunc(a)
    r2 = trunc(b)
    r3 = trunc(h)
    r4 = trunc(-h)
    r5 = trunc(t)
    r6 = trunc(-0.999)
    c1 = trunc(ka)
    c2 = trunc(kb)
    c3 = trunc(kh)
    c4 = trunc(-kh)
    c5 = trunc(kt)
    c6 = trunc(-0.999)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2.75
    b = -2.75
    h = -0.5
    t = -5e-324
    @assert r1 == 2
    @assert r2 == -2
    @assert 1 / r3 == -1/0
    @assert 1 / r4 == 1/0
    @assert 1 / r5 == -1/0
    @assert 1 / r6 == -1/0
    @assert c1 == 2
    @assert c2 == -2
    @assert 1 / c3 == -1/0
    @assert 1 / c4 == 1/0
    @assert 1 / c5 == -1/0
    @assert 1 / c6 == -1/0
    @stop
}
