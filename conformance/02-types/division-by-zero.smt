spec 2.9  Dividing by zero gives an infinity with the sign of both; nothing stops.

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
F64  kz = 0 @read_only
F64  kn = -0.0 @read_only
F64  ka = 5 @read_only

[Run]
.step
    r1 = a / z
    r2 = -a / z
    r3 = a / n
    r4 = a / z - 1
    r5 = (z / z == z / z) + 1
    r6 = 1 / (a / z)
    r7 = (a / z) / (a / z) != 1
    r8 = z / a
    c1 = ka / kz
    c2 = -ka / kz
    c3 = ka / kn
    c4 = ka / kz - 1
    c5 = (kz / kz == kz / kz) + 1
    c6 = 1 / (ka / kz)
    c7 = (ka / kz) / (ka / kz) != 1
    c8 = kz / ka

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    n = -0.0
    a = 5
    @assert r1 == 1/0
    @assert r2 == -1/0
    @assert r3 == -1/0
    @assert r4 == 1/0
    @assert r5 == 1
    @assert 1 / r6 == 1/0
    @assert r7 == 1
    @assert 1 / r8 == 1/0
    @assert c1 == 1/0
    @assert c2 == -1/0
    @assert c3 == -1/0
    @assert c4 == 1/0
    @assert c5 == 1
    @assert 1 / c6 == 1/0
    @assert c7 == 1
    @assert 1 / c8 == 1/0
    @stop
}
