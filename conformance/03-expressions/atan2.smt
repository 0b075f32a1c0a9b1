spec 3.39  atan2 is the angle of a point, from -pi to pi.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a0
F64 b0
F64 r0
F64 c0
F64 a1
F64 b1
F64 r1
F64 c1
F64 a2
F64 b2
F64 r2
F64 c2
F64 a3
F64 b3
F64 r3
F64 c3
F64 a4
F64 b4
F64 r4
F64 c4
F64 a5
F64 b5
F64 r5
F64 c5
F64 a6
F64 b6
F64 r6
F64 c6
F64 a7
F64 b7
F64 r7
F64 c7
F64 a8
F64 b8
F64 r8
F64 c8
F64 a9
F64 b9
F64 r9
F64 c9
F64 a10
F64 b10
F64 r10
F64 c10
F64 a11
F64 b11
F64 r11
F64 c11
F64 a12
F64 b12
F64 r12
F64 c12

[Run]
.step
    r0 = atan2(a0, b0)
    c0 = atan2(1, 1)
    r1 = atan2(a1, b1)
    c1 = atan2(1, -1)
    r2 = atan2(a2, b2)
    c2 = atan2(-1, 1)
    r3 = atan2(a3, b3)
    c3 = atan2(-1, -1)
    r4 = atan2(a4, b4)
    c4 = atan2(0, 1)
    r5 = atan2(a5, b5)
    c5 = atan2(0, -1)
    r6 = atan2(a6, b6)
    c6 = atan2(1, 0)
    r7 = atan2(a7, b7)
    c7 = atan2(-1, 0)
    r8 = atan2(a8, b8)
    c8 = atan2(0, 0)
    r9 = atan2(a9, b9)
    c9 = atan2(3e300, 1e300)
    r10 = atan2(a10, b10)
    c10 = atan2(1e-300, 4e-300)
    r11 = atan2(a11, b11)
    c11 = atan2(1e-300, 1e300)
    r12 = atan2(a12, b12)
    c12 = atan2(0.1, -7)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a0 = 1
    b0 = 1
    a1 = 1
    b1 = -1
    a2 = -1
    b2 = 1
    a3 = -1
    b3 = -1
    a4 = 0
    b4 = 1
    a5 = 0
    b5 = -1
    a6 = 1
    b6 = 0
    a7 = -1
    b7 = 0
    a8 = 0
    b8 = 0
    a9 = 3e300
    b9 = 1e300
    a10 = 1e-300
    b10 = 4e-300
    a11 = 1e-300
    b11 = 1e300
    a12 = 0.1
    b12 = -7
    @assert r0 == 0.7853981633974483
    @assert c0 == 0.7853981633974483
    @assert r1 == 2.356194490192345
    @assert c1 == 2.356194490192345
    @assert r2 == -0.7853981633974483
    @assert c2 == -0.7853981633974483
    @assert r3 == -2.356194490192345
    @assert c3 == -2.356194490192345
    @assert r4 == 0.0
    @assert c4 == 0.0
    @assert r5 == 3.141592653589793
    @assert c5 == 3.141592653589793
    @assert r6 == 1.5707963267948966
    @assert c6 == 1.5707963267948966
    @assert r7 == -1.5707963267948966
    @assert c7 == -1.5707963267948966
    @assert r8 == 0.0
    @assert c8 == 0.0
    @assert r9 == 1.2490457723982544
    @assert c9 == 1.2490457723982544
    @assert r10 == 0.24497866312686414
    @assert c10 == 0.24497866312686414
    @assert r11 == 0.0
    @assert c11 == 0.0
    @assert r12 == 3.1273079110023967
    @assert c12 == 3.1273079110023967
    @stop
}
