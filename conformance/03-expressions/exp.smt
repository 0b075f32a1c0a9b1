spec 3.34  exp is e to the power x, infinity where that is too large, 0 of negative infinity.

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

[Run]
.step
    r0 = exp(a0)
    c0 = exp(1)
    r1 = exp(a1)
    c1 = exp(-1)
    r2 = exp(a2)
    c2 = exp(0)
    r3 = exp(a3)
    c3 = exp(0.5)
    r4 = exp(a4)
    c4 = exp(-0.693)
    r5 = exp(a5)
    c5 = exp(88.7)
    r6 = exp(a6)
    c6 = exp(709.78)
    r7 = exp(a7)
    c7 = exp(709.79)
    r8 = exp(a8)
    c8 = exp(-745.1)
    r9 = exp(a9)
    c9 = exp(-745.2)
    r10 = exp(a10)
    c10 = exp(1e300)
    r11 = exp(a11)
    c11 = exp(-1e300)
    r12 = exp(a12)
    c12 = exp(5e-324)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a0 = 1
    a1 = -1
    a2 = 0
    a3 = 0.5
    a4 = -0.693
    a5 = 88.7
    a6 = 709.78
    a7 = 709.79
    a8 = -745.1
    a9 = -745.2
    a10 = 1e300
    a11 = -1e300
    a12 = 5e-324
    @assert r0 == 2.718281828459045
    @assert c0 == 2.718281828459045
    @assert r1 == 0.36787944117144233
    @assert c1 == 0.36787944117144233
    @assert r2 == 1.0
    @assert c2 == 1.0
    @assert r3 == 1.6487212707001282
    @assert c3 == 1.6487212707001282
    @assert r4 == 0.5000735956957677
    @assert c4 == 0.5000735956957677
    @assert r5 == 3.325986980250579e+38
    @assert c5 == 3.325986980250579e+38
    @assert r6 == 1.7928227943945155e+308
    @assert c6 == 1.7928227943945155e+308
    @assert r7 == 1 / 0
    @assert c7 == 1 / 0
    @assert r8 == 5e-324
    @assert c8 == 5e-324
    @assert r9 == 0.0
    @assert c9 == 0.0
    @assert r10 == 1 / 0
    @assert c10 == 1 / 0
    @assert r11 == 0.0
    @assert c11 == 0.0
    @assert r12 == 1.0
    @assert c12 == 1.0
    @stop
}
