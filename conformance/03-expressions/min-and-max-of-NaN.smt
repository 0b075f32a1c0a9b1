spec 3.27  NaN on either side makes the result NaN.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  z
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
F64  ka = 1 @read_only

[Run]
.step
    r1 = min(z / z, a) == min(z / z, a)
    r2 = min(a, z / z) != a
    r3 = min(a, z / z) == min(a, z / z)
    r4 = max(z / z, a) == max(z / z, a)
    r5 = max(a, z / z) == max(a, z / z)
    c1 = min(kz / kz, ka) == min(kz / kz, ka)
    c2 = min(ka, kz / kz) != ka
    c3 = min(ka, kz / kz) == min(ka, kz / kz)
    c4 = max(kz / kz, ka) == max(kz / kz, ka)
    c5 = max(ka, kz / kz) == max(ka, kz / kz)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    a = 1
    @assert 1 / r1 == 1/0
    @assert r2 == 1
    @assert 1 / r3 == 1/0
    @assert 1 / r4 == 1/0
    @assert 1 / r5 == 1/0
    @assert 1 / c1 == 1/0
    @assert c2 == 1
    @assert 1 / c3 == 1/0
    @assert 1 / c4 == 1/0
    @assert 1 / c5 == 1/0
    @stop
}
