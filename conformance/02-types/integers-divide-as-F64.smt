spec 2.6, 2.9  Dividing whole numbers is F64 division, by zero too.

-- app.sm --
[state_vector]
U64 G
U32 S
I16  a
U8   b
I32  n
I32  m
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
I16  ka = -7 @read_only
U8   kb = 2 @read_only
I32  kn = 0 @read_only
I32  km = -2147483648 @read_only

[Run]
.step
    r1 = a / b
    r2 = a / n
    r3 = b / n
    r4 = a / -n
    r5 = m / -1
    r6 = 1 / b / b
    r7 = a / 3
    r8 = a / 3 * 3
    r9 = b / a
    r10 = (n / n == n / n) + 0
    r11 = n / a
    r12 = a / b * b
    c1 = ka / kb
    c2 = ka / kn
    c3 = kb / kn
    c4 = ka / -kn
    c5 = km / -1
    c6 = 1 / kb / kb
    c7 = ka / 3
    c8 = ka / 3 * 3
    c9 = kb / ka
    c10 = (kn / kn == kn / kn) + 0
    c11 = kn / ka
    c12 = ka / kb * kb

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = -7
    b = 2
    n = 0
    m = -2147483648
    @assert r1 == -3.5
    @assert r2 == -1/0
    @assert r3 == 1/0
    @assert r4 == 1/0
    @assert r5 == 2147483648
    @assert r6 == 0.25
    @assert r7 == -2.3333333333333335
    @assert r8 == -7
    @assert r9 == -0.2857142857142857
    @assert 1 / r10 == 1/0
    @assert 1 / r11 == -1/0
    @assert r12 == -7
    @assert c1 == -3.5
    @assert c2 == -1/0
    @assert c3 == 1/0
    @assert c4 == 1/0
    @assert c5 == 2147483648
    @assert c6 == 0.25
    @assert c7 == -2.3333333333333335
    @assert c8 == -7
    @assert c9 == -0.2857142857142857
    @assert 1 / c10 == 1/0
    @assert 1 / c11 == -1/0
    @assert c12 == -7
    @stop
}
