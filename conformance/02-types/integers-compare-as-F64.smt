spec 2.6, 2.10, 2.3  Whole numbers of different types compare by value, above 2^53 by the nearest F64.

-- app.sm --
[state_vector]
U64 G
U32 S
I8   s
U8   u
U64  w
I64  i
U32  k
I32  j
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
F64  r13
F64  r14
F64  r15
F64  r16
F64  r17
F64  r18
F64  r19
F64  r20
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
F64  c13
F64  c14
F64  c15
F64  c16
F64  c17
F64  c18
F64  c19
F64  c20

[local]
I8   ks = -1 @read_only
U8   ku = 255 @read_only
U64  kw = 1e30 @read_only
I64  ki = -1e30 @read_only
U32  kk = 4294967295 @read_only
I32  kj = -1 @read_only

[Run]
.step
    r1 = s < u
    r2 = s == u
    r3 = j < k
    r4 = j == k
    r5 = w > i
    r6 = i < 0
    r7 = w == 18446744073709551616
    r8 = w >= 18446744073709551615
    r9 = w + 1 == w
    r10 = s > 0.5
    r11 = -0.5 > s
    r12 = u < 255.5
    r13 = u > 254.5
    r14 = s >= -1.0
    r15 = k < 1/0
    r16 = i > -1/0
    r17 = k == 4294967295.5
    r18 = u == 1e300
    r19 = u < 1e300
    r20 = s > -1e300
    c1 = ks < ku
    c2 = ks == ku
    c3 = kj < kk
    c4 = kj == kk
    c5 = kw > ki
    c6 = ki < 0
    c7 = kw == 18446744073709551616
    c8 = kw >= 18446744073709551615
    c9 = kw + 1 == kw
    c10 = ks > 0.5
    c11 = -0.5 > ks
    c12 = ku < 255.5
    c13 = ku > 254.5
    c14 = ks >= -1.0
    c15 = kk < 1/0
    c16 = ki > -1/0
    c17 = kk == 4294967295.5
    c18 = ku == 1e300
    c19 = ku < 1e300
    c20 = ks > -1e300

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    s = -1
    u = 255
    w = 1e30
    i = -1e30
    k = 4294967295
    j = -1
    @assert r1 == 1
    @assert 1 / r2 == 1/0
    @assert r3 == 1
    @assert 1 / r4 == 1/0
    @assert r5 == 1
    @assert r6 == 1
    @assert r7 == 1
    @assert r8 == 1
    @assert r9 == 1
    @assert 1 / r10 == 1/0
    @assert r11 == 1
    @assert r12 == 1
    @assert r13 == 1
    @assert r14 == 1
    @assert r15 == 1
    @assert r16 == 1
    @assert 1 / r17 == 1/0
    @assert 1 / r18 == 1/0
    @assert r19 == 1
    @assert r20 == 1
    @assert c1 == 1
    @assert 1 / c2 == 1/0
    @assert c3 == 1
    @assert 1 / c4 == 1/0
    @assert c5 == 1
    @assert c6 == 1
    @assert c7 == 1
    @assert c8 == 1
    @assert c9 == 1
    @assert 1 / c10 == 1/0
    @assert c11 == 1
    @assert c12 == 1
    @assert c13 == 1
    @assert c14 == 1
    @assert c15 == 1
    @assert c16 == 1
    @assert 1 / c17 == 1/0
    @assert 1 / c18 == 1/0
    @assert c19 == 1
    @assert c20 == 1
    @stop
}
