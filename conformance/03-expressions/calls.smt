spec 3.17  Arguments are any expressions, calls and chains included.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  c
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
F64  ka = 2 @read_only
F64  kb = -3 @read_only
F64  kc = 5 @read_only

[Run]
.step
    r1 = max(a, b)
    r2 = max(a + b, a * c)
    r3 = min(max(a, b), abs(b))
    r4 = abs(b) + sqrt(4) * 2
    r5 = -abs(b)
    r6 = max(a < c < 9, 0)
    r7 = max((a), (b and c))
    r8 = clamp(a + 10, b, c)
    r9 = clamp(b - 10, b, c)
    r10 = clamp(a, c, c + 1)
    r11 = abs (b)
    r12 = not abs(b)
    c1 = max(ka, kb)
    c2 = max(ka + kb, ka * kc)
    c3 = min(max(ka, kb), abs(kb))
    c4 = abs(kb) + sqrt(4) * 2
    c5 = -abs(kb)
    c6 = max(ka < kc < 9, 0)
    c7 = max((ka), (kb and kc))
    c8 = clamp(ka + 10, kb, kc)
    c9 = clamp(kb - 10, kb, kc)
    c10 = clamp(ka, kc, kc + 1)
    c11 = abs (kb)
    c12 = not abs(kb)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2
    b = -3
    c = 5
    @assert r1 == 2
    @assert r2 == 10
    @assert r3 == 2
    @assert r4 == 7
    @assert r5 == -3
    @assert r6 == 1
    @assert r7 == 2
    @assert r8 == 5
    @assert r9 == -3
    @assert r10 == 5
    @assert r11 == 3
    @assert 1 / r12 == 1/0
    @assert c1 == 2
    @assert c2 == 10
    @assert c3 == 2
    @assert c4 == 7
    @assert c5 == -3
    @assert c6 == 1
    @assert c7 == 2
    @assert c8 == 5
    @assert c9 == -3
    @assert c10 == 5
    @assert c11 == 3
    @assert 1 / c12 == 1/0
    @stop
}
