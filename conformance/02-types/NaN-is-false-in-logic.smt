spec 2.23  and, or and not take NaN as false.

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
F64  ka = 1 @read_only

[Run]
.step
    r1 = z / z and a
    r2 = a and z / z
    r3 = z / z or z
    r4 = z / z or a
    r5 = z or z / z
    r6 = not (z / z)
    r7 = !!(z / z)
    r8 = not (z / z or z / z)
    c1 = kz / kz and ka
    c2 = ka and kz / kz
    c3 = kz / kz or kz
    c4 = kz / kz or ka
    c5 = kz or kz / kz
    c6 = not (kz / kz)
    c7 = !!(kz / kz)
    c8 = not (kz / kz or kz / kz)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    a = 1
    @assert 1 / r1 == 1/0
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert r4 == 1
    @assert 1 / r5 == 1/0
    @assert r6 == 1
    @assert 1 / r7 == 1/0
    @assert r8 == 1
    @assert 1 / c1 == 1/0
    @assert 1 / c2 == 1/0
    @assert 1 / c3 == 1/0
    @assert c4 == 1
    @assert 1 / c5 == 1/0
    @assert c6 == 1
    @assert 1 / c7 == 1/0
    @assert c8 == 1
    @stop
}
