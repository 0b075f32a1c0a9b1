spec 3.36  pow of positive and negative numbers.

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
F64 a13
F64 b13
F64 r13
F64 c13
F64 a14
F64 b14
F64 r14
F64 c14
F64 a15
F64 b15
F64 r15
F64 c15

[Run]
.step
    r0 = pow(a0, b0)
    c0 = pow(2, 10)
    r1 = pow(a1, b1)
    c1 = pow(10, -3)
    r2 = pow(a2, b2)
    c2 = pow(2, 0.5)
    r3 = pow(a3, b3)
    c3 = pow(-2, 3)
    r4 = pow(a4, b4)
    c4 = pow(-2, 2)
    r5 = pow(a5, b5)
    c5 = pow(-8, -1)
    r6 = pow(a6, b6)
    c6 = pow(9, 0.5)
    r7 = pow(a7, b7)
    c7 = pow(1.1, 7000)
    r8 = pow(a8, b8)
    c8 = pow(0.9, 7000)
    r9 = pow(a9, b9)
    c9 = pow(7, 0)
    r10 = pow(a10, b10)
    c10 = pow(1, 1e300)
    r11 = pow(a11, b11)
    c11 = pow(0.9988, 5.255)
    r12 = pow(a12, b12)
    c12 = pow(-1, 9007199254740993)
    r13 = pow(a13, b13)
    c13 = pow(2, -1074)
    r14 = pow(a14, b14)
    c14 = pow(0, 3)
    r15 = pow(a15, b15)
    c15 = pow(0, -2)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a0 = 2
    b0 = 10
    a1 = 10
    b1 = -3
    a2 = 2
    b2 = 0.5
    a3 = -2
    b3 = 3
    a4 = -2
    b4 = 2
    a5 = -8
    b5 = -1
    a6 = 9
    b6 = 0.5
    a7 = 1.1
    b7 = 7000
    a8 = 0.9
    b8 = 7000
    a9 = 7
    b9 = 0
    a10 = 1
    b10 = 1e300
    a11 = 0.9988
    b11 = 5.255
    a12 = -1
    b12 = 9007199254740993
    a13 = 2
    b13 = -1074
    a14 = 0
    b14 = 3
    a15 = 0
    b15 = -2
    @assert r0 == 1024.0
    @assert c0 == 1024.0
    @assert r1 == 0.001
    @assert c1 == 0.001
    @assert r2 == 1.4142135623730951
    @assert c2 == 1.4142135623730951
    @assert r3 == -8.0
    @assert c3 == -8.0
    @assert r4 == 4.0
    @assert c4 == 4.0
    @assert r5 == -0.125
    @assert c5 == -0.125
    @assert r6 == 3.0
    @assert c6 == 3.0
    @assert r7 == 5.607846372419733e+289
    @assert c7 == 5.607846372419733e+289
    @assert r8 == 4.985e-321
    @assert c8 == 4.985e-321
    @assert r9 == 1.0
    @assert c9 == 1.0
    @assert r10 == 1.0
    @assert c10 == 1.0
    @assert r11 == 0.9937100782709942
    @assert c11 == 0.9937100782709942
    @assert r12 == 1.0
    @assert c12 == 1.0
    @assert r13 == 5e-324
    @assert c13 == 5e-324
    @assert r14 == 0.0
    @assert c14 == 0.0
    @assert r15 == 1 / 0
    @assert c15 == 1 / 0
    @stop
}
