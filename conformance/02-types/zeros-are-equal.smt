spec 2.10  0 and −0 are equal in every comparison.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  z
F64  n
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
F64  kz = 0 @read_only
F64  kn = -0.0 @read_only

[Run]
.step
    r1 = z == n
    r2 = z != n
    r3 = n < z
    r4 = n >= z
    r5 = z <= n
    r6 = z > n
    c1 = kz == kn
    c2 = kz != kn
    c3 = kn < kz
    c4 = kn >= kz
    c5 = kz <= kn
    c6 = kz > kn

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    n = -0.0
    @assert r1 == 1
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert r4 == 1
    @assert r5 == 1
    @assert 1 / r6 == 1/0
    @assert c1 == 1
    @assert 1 / c2 == 1/0
    @assert 1 / c3 == 1/0
    @assert c4 == 1
    @assert c5 == 1
    @assert 1 / c6 == 1/0
    @stop
}
