spec 3.40  hypot is the length of a vector, without overflow on the way.

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

[Run]
.step
    r0 = hypot(a0, b0)
    c0 = hypot(3, 4)
    r1 = hypot(a1, b1)
    c1 = hypot(-5, 12)
    r2 = hypot(a2, b2)
    c2 = hypot(1, 1)
    r3 = hypot(a3, b3)
    c3 = hypot(3e300, 4e300)
    r4 = hypot(a4, b4)
    c4 = hypot(1e308, 1.6e308)
    r5 = hypot(a5, b5)
    c5 = hypot(3e-320, 4e-320)
    r6 = hypot(a6, b6)
    c6 = hypot(1, 1e-20)
    r7 = hypot(a7, b7)
    c7 = hypot(0, -7)
    r8 = hypot(a8, b8)
    c8 = hypot(0, 0)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a0 = 3
    b0 = 4
    a1 = -5
    b1 = 12
    a2 = 1
    b2 = 1
    a3 = 3e300
    b3 = 4e300
    a4 = 1e308
    b4 = 1.6e308
    a5 = 3e-320
    b5 = 4e-320
    a6 = 1
    b6 = 1e-20
    a7 = 0
    b7 = -7
    a8 = 0
    b8 = 0
    @assert r0 == 5.0
    @assert c0 == 5.0
    @assert r1 == 13.0
    @assert c1 == 13.0
    @assert r2 == 1.4142135623730951
    @assert c2 == 1.4142135623730951
    @assert r3 == 5e+300
    @assert c3 == 5e+300
    @assert r4 == 1 / 0
    @assert c4 == 1 / 0
    @assert r5 == 5e-320
    @assert c5 == 5e-320
    @assert r6 == 1.0
    @assert c6 == 1.0
    @assert r7 == 7.0
    @assert c7 == 7.0
    @assert r8 == 0.0
    @assert c8 == 0.0
    @stop
}
