spec 3.19  abs drops the sign, of −0 and −inf too.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  z
F64  i
F64  s
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
F64  ka = -2.5 @read_only
F64  kz = -0.0 @read_only
F64  ki = -1/0 @read_only
F64  ks = -5e-324 @read_only

[Run]
.step
    r1 = abs(a)
    r2 = abs(-a)
    r3 = abs(z)
    r4 = abs(i)
    r5 = abs(s)
    r6 = abs(0)
    c1 = abs(ka)
    c2 = abs(-ka)
    c3 = abs(kz)
    c4 = abs(ki)
    c5 = abs(ks)
    c6 = abs(0)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = -2.5
    z = -0.0
    i = -1/0
    s = -5e-324
    @assert r1 == 2.5
    @assert r2 == 2.5
    @assert 1 / r3 == 1/0
    @assert r4 == 1/0
    @assert r5 == 5e-324
    @assert 1 / r6 == 1/0
    @assert c1 == 2.5
    @assert c2 == 2.5
    @assert 1 / c3 == 1/0
    @assert c4 == 1/0
    @assert c5 == 5e-324
    @assert 1 / c6 == 1/0
    @stop
}
