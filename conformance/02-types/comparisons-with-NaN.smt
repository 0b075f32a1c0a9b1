spec 2.11  Of the comparisons with NaN only != is true, on either side and with itself.

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
F64  r6
F64  r7
F64  r8
F64  r9
F64  r10
F64  r11
F64  r12
F64  r13
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6
F64  c7
F64  c8
F64  c9
F64  c10
F64  c11
F64  c12
F64  c13

[local]
F64  kz = 0 @read_only
F64  ka = 1 @read_only

[Run]
.step
    r1 = z / z == z / z
    r2 = z / z != z / z
    r3 = z / z < a
    r4 = z / z > a
    r5 = z / z <= a
    r6 = z / z >= a
    r7 = a < z / z
    r8 = a > z / z
    r9 = a <= z / z
    r10 = a >= z / z
    r11 = a == z / z
    r12 = a != z / z
    r13 = not (z / z < a)
    c1 = kz / kz == kz / kz
    c2 = kz / kz != kz / kz
    c3 = kz / kz < ka
    c4 = kz / kz > ka
    c5 = kz / kz <= ka
    c6 = kz / kz >= ka
    c7 = ka < kz / kz
    c8 = ka > kz / kz
    c9 = ka <= kz / kz
    c10 = ka >= kz / kz
    c11 = ka == kz / kz
    c12 = ka != kz / kz
    c13 = not (kz / kz < ka)

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
    @assert 1 / r6 == 1/0
    @assert 1 / r7 == 1/0
    @assert 1 / r8 == 1/0
    @assert 1 / r9 == 1/0
    @assert 1 / r10 == 1/0
    @assert 1 / r11 == 1/0
    @assert r12 == 1
    @assert r13 == 1
    @assert 1 / c1 == 1/0
    @assert c2 == 1
    @assert 1 / c3 == 1/0
    @assert 1 / c4 == 1/0
    @assert 1 / c5 == 1/0
    @assert 1 / c6 == 1/0
    @assert 1 / c7 == 1/0
    @assert 1 / c8 == 1/0
    @assert 1 / c9 == 1/0
    @assert 1 / c10 == 1/0
    @assert 1 / c11 == 1/0
    @assert c12 == 1
    @assert c13 == 1
    @stop
}
