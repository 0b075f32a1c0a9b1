spec 2.12  The sign of a NaN cannot be made visible: stored it is +0, and abs, sign, - and min do not tell two NaN apart.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 z
F64 a
F64 b
F32 c
F64 d
F64 e

[Run]
.step
    a = z / z
    b = -(z / z)
    c = -(z / z)
    d = abs(-(z / z)) < 0
    e = sign(-(z / z))

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    @assert 1 / a == 1/0
    @assert 1 / b == 1/0
    @assert 1 / c == 1/0
    @assert d == 0
    @assert 1 / e == 1/0
    @stop
}

-- trace --
1 a 0x0p+0
1 b 0x0p+0
1 c 0x0p+0
1 d 0x0p+0
1 e 0x0p+0
