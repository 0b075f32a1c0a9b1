spec 2.8  x * 0, x - x, x / x and x + 0 are calculated, for infinities and zeros too, and division is not replaced by multiplication.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  i
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

[local]
F64  ki = 1/0 @read_only
F64  kz = -0.0 @read_only
F64  ka = 49 @read_only

[Run]
.step
    r1 = i * 0 == i * 0
    r2 = i - i == 0
    r3 = i / i == 1
    r4 = z + 0
    r5 = z - 0
    r6 = z * 1
    r7 = 0 * -a
    r8 = a * (1 / a)
    r9 = a / 3
    r10 = a - a
    r11 = 0 - z
    r12 = z / 5
    c1 = ki * 0 == ki * 0
    c2 = ki - ki == 0
    c3 = ki / ki == 1
    c4 = kz + 0
    c5 = kz - 0
    c6 = kz * 1
    c7 = 0 * -ka
    c8 = ka * (1 / ka)
    c9 = ka / 3
    c10 = ka - ka
    c11 = 0 - kz
    c12 = kz / 5

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    i = 1/0
    z = -0.0
    a = 49
    @assert 1 / r1 == 1/0
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert 1 / r4 == 1/0
    @assert 1 / r5 == -1/0
    @assert 1 / r6 == -1/0
    @assert 1 / r7 == -1/0
    @assert r8 == 0.9999999999999999
    @assert r9 == 16.333333333333332
    @assert 1 / r10 == 1/0
    @assert 1 / r11 == 1/0
    @assert 1 / r12 == -1/0
    @assert 1 / c1 == 1/0
    @assert 1 / c2 == 1/0
    @assert 1 / c3 == 1/0
    @assert 1 / c4 == 1/0
    @assert 1 / c5 == -1/0
    @assert 1 / c6 == -1/0
    @assert 1 / c7 == -1/0
    @assert c8 == 0.9999999999999999
    @assert c9 == 16.333333333333332
    @assert 1 / c10 == 1/0
    @assert 1 / c11 == 1/0
    @assert 1 / c12 == -1/0
    @stop
}
