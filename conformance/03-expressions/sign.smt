spec 3.25  sign gives −1, 1 or the zero itself.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  z
F64  n
F64  i
F64  s
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
F64  ka = 0.1 @read_only
F64  kb = -1e300 @read_only
F64  kz = 0 @read_only
F64  kn = -0.0 @read_only
F64  ki = -1/0 @read_only
F64  ks = 5e-324 @read_only

[Run]
.step
    r1 = sign(a)
    r2 = sign(b)
    r3 = sign(z)
    r4 = sign(n)
    r5 = sign(i)
    r6 = sign(s)
    r7 = sign(z / z) == sign(z / z)
    c1 = sign(ka)
    c2 = sign(kb)
    c3 = sign(kz)
    c4 = sign(kn)
    c5 = sign(ki)
    c6 = sign(ks)
    c7 = sign(kz / kz) == sign(kz / kz)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0.1
    b = -1e300
    z = 0
    n = -0.0
    i = -1/0
    s = 5e-324
    @assert r1 == 1
    @assert r2 == -1
    @assert 1 / r3 == 1/0
    @assert 1 / r4 == -1/0
    @assert r5 == -1
    @assert r6 == 1
    @assert 1 / r7 == 1/0
    @assert c1 == 1
    @assert c2 == -1
    @assert 1 / c3 == 1/0
    @assert 1 / c4 == -1/0
    @assert c5 == -1
    @assert c6 == 1
    @assert 1 / c7 == 1/0
    @stop
}
