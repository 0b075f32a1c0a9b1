spec 3.28, 3.27  clamp is min(max(x, lo), hi): NaN stays, and zeros are ordered.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  z
F64  n
F64  a
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5

[local]
F64  kz = 0 @read_only
F64  kn = -0.0 @read_only
F64  ka = 1 @read_only

[Run]
.step
    r1 = clamp(z / z, n, a) == clamp(z / z, n, a)
    r2 = clamp(a, z / z, a) == clamp(a, z / z, a)
    r3 = clamp(n, z, a)
    r4 = clamp(z, n, n)
    r5 = clamp(a, n, z / z) != 1
    c1 = clamp(kz / kz, kn, ka) == clamp(kz / kz, kn, ka)
    c2 = clamp(ka, kz / kz, ka) == clamp(ka, kz / kz, ka)
    c3 = clamp(kn, kz, ka)
    c4 = clamp(kz, kn, kn)
    c5 = clamp(ka, kn, kz / kz) != 1

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    n = -0.0
    a = 1
    @assert 1 / r1 == 1/0
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert 1 / r4 == -1/0
    @assert r5 == 1
    @assert 1 / c1 == 1/0
    @assert 1 / c2 == 1/0
    @assert 1 / c3 == 1/0
    @assert 1 / c4 == -1/0
    @assert c5 == 1
    @stop
}
