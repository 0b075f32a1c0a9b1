spec 3.29, 2.14  NaN stays NaN through floor, ceil, trunc, round and abs.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  z
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
F64  kz = 0 @read_only

[Run]
.step
    r1 = floor(z / z) != floor(z / z)
    r2 = ceil(z / z) != ceil(z / z)
    r3 = trunc(z / z) != trunc(z / z)
    r4 = round(z / z) != round(z / z)
    r5 = abs(z / z) != abs(z / z)
    r6 = sqrt(z / z) != sqrt(z / z)
    r7 = sign(z / z) != sign(z / z)
    c1 = floor(kz / kz) != floor(kz / kz)
    c2 = ceil(kz / kz) != ceil(kz / kz)
    c3 = trunc(kz / kz) != trunc(kz / kz)
    c4 = round(kz / kz) != round(kz / kz)
    c5 = abs(kz / kz) != abs(kz / kz)
    c6 = sqrt(kz / kz) != sqrt(kz / kz)
    c7 = sign(kz / kz) != sign(kz / kz)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    @assert r1 == 1
    @assert r2 == 1
    @assert r3 == 1
    @assert r4 == 1
    @assert r5 == 1
    @assert r6 == 1
    @assert r7 == 1
    @assert c1 == 1
    @assert c2 == 1
    @assert c3 == 1
    @assert c4 == 1
    @assert c5 == 1
    @assert c6 == 1
    @assert c7 == 1
    @stop
}
