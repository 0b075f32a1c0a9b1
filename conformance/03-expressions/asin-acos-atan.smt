spec 3.38  asin, acos and atan return angles.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a0
F64 r0
F64 c0
F64 a1
F64 r1
F64 c1
F64 a2
F64 r2
F64 c2
F64 a3
F64 r3
F64 c3
F64 a4
F64 r4
F64 c4
F64 a5
F64 r5
F64 c5
F64 a6
F64 r6
F64 c6
F64 a7
F64 r7
F64 c7
F64 a8
F64 r8
F64 c8
F64 a9
F64 r9
F64 c9
F64 a10
F64 r10
F64 c10
F64 a11
F64 r11
F64 c11
F64 a12
F64 r12
F64 c12
F64 a13
F64 r13
F64 c13
F64 a14
F64 r14
F64 c14
F64 a15
F64 r15
F64 c15
F64 a16
F64 r16
F64 c16
F64 a17
F64 r17
F64 c17
F64 a18
F64 r18
F64 c18
F64 a19
F64 r19
F64 c19

[Run]
.step
    r0 = asin(a0)
    c0 = asin(0)
    r1 = asin(a1)
    c1 = asin(0.5)
    r2 = asin(a2)
    c2 = asin(-0.5)
    r3 = asin(a3)
    c3 = asin(1)
    r4 = asin(a4)
    c4 = asin(-1)
    r5 = asin(a5)
    c5 = asin(0.999999)
    r6 = asin(a6)
    c6 = asin(1e-20)
    r7 = acos(a7)
    c7 = acos(0)
    r8 = acos(a8)
    c8 = acos(0.5)
    r9 = acos(a9)
    c9 = acos(-0.5)
    r10 = acos(a10)
    c10 = acos(1)
    r11 = acos(a11)
    c11 = acos(-1)
    r12 = acos(a12)
    c12 = acos(0.999999)
    r13 = acos(a13)
    c13 = acos(1e-20)
    r14 = atan(a14)
    c14 = atan(0)
    r15 = atan(a15)
    c15 = atan(0.3)
    r16 = atan(a16)
    c16 = atan(-1)
    r17 = atan(a17)
    c17 = atan(20)
    r18 = atan(a18)
    c18 = atan(1e300)
    r19 = atan(a19)
    c19 = atan(-1e-30)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a0 = 0
    a1 = 0.5
    a2 = -0.5
    a3 = 1
    a4 = -1
    a5 = 0.999999
    a6 = 1e-20
    a7 = 0
    a8 = 0.5
    a9 = -0.5
    a10 = 1
    a11 = -1
    a12 = 0.999999
    a13 = 1e-20
    a14 = 0
    a15 = 0.3
    a16 = -1
    a17 = 20
    a18 = 1e300
    a19 = -1e-30
    @assert r0 == 0.0
    @assert c0 == 0.0
    @assert r1 == 0.5235987755982989
    @assert c1 == 0.5235987755982989
    @assert r2 == -0.5235987755982989
    @assert c2 == -0.5235987755982989
    @assert r3 == 1.5707963267948966
    @assert c3 == 1.5707963267948966
    @assert r4 == -1.5707963267948966
    @assert c4 == -1.5707963267948966
    @assert r5 == 1.5693821131146521
    @assert c5 == 1.5693821131146521
    @assert r6 == 1e-20
    @assert c6 == 1e-20
    @assert r7 == 1.5707963267948966
    @assert c7 == 1.5707963267948966
    @assert r8 == 1.0471975511965979
    @assert c8 == 1.0471975511965979
    @assert r9 == 2.0943951023931957
    @assert c9 == 2.0943951023931957
    @assert r10 == 0.0
    @assert c10 == 0.0
    @assert r11 == 3.141592653589793
    @assert c11 == 3.141592653589793
    @assert r12 == 0.0014142136802445852
    @assert c12 == 0.0014142136802445852
    @assert r13 == 1.5707963267948966
    @assert c13 == 1.5707963267948966
    @assert r14 == 0.0
    @assert c14 == 0.0
    @assert r15 == 0.2914567944778671
    @assert c15 == 0.2914567944778671
    @assert r16 == -0.7853981633974483
    @assert c16 == -0.7853981633974483
    @assert r17 == 1.5208379310729538
    @assert c17 == 1.5208379310729538
    @assert r18 == 1.5707963267948966
    @assert c18 == 1.5707963267948966
    @assert r19 == -1e-30
    @assert c19 == -1e-30
    @stop
}
