spec 3.21  ceil goes up; between −1 and 0 it gives −0.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  h
F64  s
F64  t
F64  w
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  r6
F64  r7
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6
F64  c7

[local]
F64  ka = 2.25 @read_only
F64  kb = -2.75 @read_only
F64  kh = -0.5 @read_only
F64  ks = 5e-324 @read_only
F64  kt = -5e-324 @read_only
F64  kw = 3 @read_only

[Run]
.step
    r1 = ceil(a)
    r2 = ceil(b)
    r3 = ceil(h)
    r4 = ceil(s)
    r5 = ceil(t)
    r6 = ceil(w)
    r7 = ceil(-h)
    c1 = ceil(ka)
    c2 = ceil(kb)
    c3 = ceil(kh)
    c4 = ceil(ks)
    c5 = ceil(kt)
    c6 = ceil(kw)
    c7 = ceil(-kh)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2.25
    b = -2.75
    h = -0.5
    s = 5e-324
    t = -5e-324
    w = 3
    @assert r1 == 3
    @assert r2 == -2
    @assert 1 / r3 == -1/0
    @assert r4 == 1
    @assert 1 / r5 == -1/0
    @assert r6 == 3
    @assert r7 == 1
    @assert c1 == 3
    @assert c2 == -2
    @assert 1 / c3 == -1/0
    @assert c4 == 1
    @assert 1 / c5 == -1/0
    @assert c6 == 3
    @assert c7 == 1
    @stop
}
