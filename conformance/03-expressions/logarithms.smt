spec 3.35  log and log10 of positive numbers.

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

[Run]
.step
    r0 = log(a0)
    c0 = log(1)
    r1 = log(a1)
    c1 = log(2)
    r2 = log(a2)
    c2 = log(10)
    r3 = log(a3)
    c3 = log(0.5)
    r4 = log(a4)
    c4 = log(1000)
    r5 = log(a5)
    c5 = log(0.1)
    r6 = log(a6)
    c6 = log(1.0000001)
    r7 = log(a7)
    c7 = log(5e-324)
    r8 = log(a8)
    c8 = log(1.7976931348623157e308)
    r9 = log10(a9)
    c9 = log10(1)
    r10 = log10(a10)
    c10 = log10(2)
    r11 = log10(a11)
    c11 = log10(10)
    r12 = log10(a12)
    c12 = log10(0.5)
    r13 = log10(a13)
    c13 = log10(1000)
    r14 = log10(a14)
    c14 = log10(0.1)
    r15 = log10(a15)
    c15 = log10(1.0000001)
    r16 = log10(a16)
    c16 = log10(5e-324)
    r17 = log10(a17)
    c17 = log10(1.7976931348623157e308)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a0 = 1
    a1 = 2
    a2 = 10
    a3 = 0.5
    a4 = 1000
    a5 = 0.1
    a6 = 1.0000001
    a7 = 5e-324
    a8 = 1.7976931348623157e308
    a9 = 1
    a10 = 2
    a11 = 10
    a12 = 0.5
    a13 = 1000
    a14 = 0.1
    a15 = 1.0000001
    a16 = 5e-324
    a17 = 1.7976931348623157e308
    @assert r0 == 0.0
    @assert c0 == 0.0
    @assert r1 == 0.6931471805599453
    @assert c1 == 0.6931471805599453
    @assert r2 == 2.302585092994046
    @assert c2 == 2.302585092994046
    @assert r3 == -0.6931471805599453
    @assert c3 == -0.6931471805599453
    @assert r4 == 6.907755278982137
    @assert c4 == 6.907755278982137
    @assert r5 == -2.3025850929940455
    @assert c5 == -2.3025850929940455
    @assert r6 == 9.999999505838704e-08
    @assert c6 == 9.999999505838704e-08
    @assert r7 == -744.4400719213812
    @assert c7 == -744.4400719213812
    @assert r8 == 709.782712893384
    @assert c8 == 709.782712893384
    @assert r9 == 0.0
    @assert c9 == 0.0
    @assert r10 == 0.3010299956639812
    @assert c10 == 0.3010299956639812
    @assert r11 == 1.0
    @assert c11 == 1.0
    @assert r12 == -0.3010299956639812
    @assert c12 == -0.3010299956639812
    @assert r13 == 3.0
    @assert c13 == 3.0
    @assert r14 == -1.0
    @assert c14 == -1.0
    @assert r15 == 4.3429446044209946e-08
    @assert c15 == 4.3429446044209946e-08
    @assert r16 == -323.3062153431158
    @assert c16 == -323.3062153431158
    @assert r17 == 308.25471555991675
    @assert c17 == 308.25471555991675
    @stop
}
