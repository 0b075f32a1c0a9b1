spec 3.24  sqrt below zero is NaN, of −0 is −0, of infinity infinity.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  n
F64  z
F64  i
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
F64  kn = -1 @read_only
F64  kz = -0.0 @read_only
F64  ki = 1/0 @read_only
F64  kt = -5e-324 @read_only

[Run]
.step
    r1 = sqrt(n) == sqrt(n)
    r2 = sqrt(z)
    r3 = sqrt(-z)
    r4 = sqrt(i)
    r5 = sqrt(-i) != 0
    r6 = sqrt(t) != sqrt(t)
    c1 = sqrt(kn) == sqrt(kn)
    c2 = sqrt(kz)
    c3 = sqrt(-kz)
    c4 = sqrt(ki)
    c5 = sqrt(-ki) != 0
    c6 = sqrt(kt) != sqrt(kt)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    n = -1
    z = -0.0
    i = 1/0
    t = -5e-324
    @assert 1 / r1 == 1/0
    @assert 1 / r2 == -1/0
    @assert 1 / r3 == 1/0
    @assert r4 == 1/0
    @assert r5 == 1
    @assert r6 == 1
    @assert 1 / c1 == 1/0
    @assert 1 / c2 == -1/0
    @assert 1 / c3 == 1/0
    @assert c4 == 1/0
    @assert c5 == 1
    @assert c6 == 1
    @stop
}
