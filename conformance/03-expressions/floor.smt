spec 3.20  floor goes down, below zero too.

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
F64  r8
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6
F64  c7
F64  c8

[local]
F64  ka = 2.75 @read_only
F64  kb = -2.25 @read_only
F64  kh = -0.5 @read_only
F64  ks = 5e-324 @read_only
F64  kt = -5e-324 @read_only
F64  kw = -3 @read_only

[Run]
.step
    r1 = floor(a)
    r2 = floor(b)
    r3 = floor(h)
    r4 = floor(s)
    r5 = floor(t)
    r6 = floor(w)
    r7 = floor(0.999999999999999)
    r8 = floor(-h)
    c1 = floor(ka)
    c2 = floor(kb)
    c3 = floor(kh)
    c4 = floor(ks)
    c5 = floor(kt)
    c6 = floor(kw)
    c7 = floor(0.999999999999999)
    c8 = floor(-kh)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2.75
    b = -2.25
    h = -0.5
    s = 5e-324
    t = -5e-324
    w = -3
    @assert r1 == 2
    @assert r2 == -3
    @assert r3 == -1
    @assert 1 / r4 == 1/0
    @assert r5 == -1
    @assert r6 == -3
    @assert 1 / r7 == 1/0
    @assert 1 / r8 == 1/0
    @assert c1 == 2
    @assert c2 == -3
    @assert c3 == -1
    @assert 1 / c4 == 1/0
    @assert c5 == -1
    @assert c6 == -3
    @assert 1 / c7 == 1/0
    @assert 1 / c8 == 1/0
    @stop
}
