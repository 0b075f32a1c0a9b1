spec 2.23, 3.14  Everything but zero and NaN counts as true in logic: 0.5, 1e-300, infinities, negative values.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  h
F64  t
F64  i
F64  n
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
F64  kh = 0.5 @read_only
F64  kt = 1e-300 @read_only
F64  ki = -1/0 @read_only
F64  kn = -0.0 @read_only

[Run]
.step
    r1 = h and t
    r2 = i and h
    r3 = n or n
    r4 = n or t
    r5 = not t
    r6 = not n
    r7 = not i
    c1 = kh and kt
    c2 = ki and kh
    c3 = kn or kn
    c4 = kn or kt
    c5 = not kt
    c6 = not kn
    c7 = not ki

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    h = 0.5
    t = 1e-300
    i = -1/0
    n = -0.0
    @assert r1 == 1
    @assert r2 == 1
    @assert 1 / r3 == 1/0
    @assert r4 == 1
    @assert 1 / r5 == 1/0
    @assert r6 == 1
    @assert 1 / r7 == 1/0
    @assert c1 == 1
    @assert c2 == 1
    @assert 1 / c3 == 1/0
    @assert c4 == 1
    @assert 1 / c5 == 1/0
    @assert c6 == 1
    @assert 1 / c7 == 1/0
    @stop
}
