spec 2.8  Sums and products are done as written: from the left unless parentheses say otherwise.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  c
F64  h
F64  k
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
F64  ka = 0.1 @read_only
F64  kb = 0.2 @read_only
F64  kc = 0.3 @read_only
F64  kh = 1e308 @read_only
F64  kk = 10 @read_only

[Run]
.step
    r1 = a + b + c
    r2 = a + (b + c)
    r3 = h * k / k
    r4 = h * (k / k)
    r5 = h + 1 - h
    r6 = h - h + 1
    r7 = a * b * c
    r8 = a * (b * c)
    c1 = ka + kb + kc
    c2 = ka + (kb + kc)
    c3 = kh * kk / kk
    c4 = kh * (kk / kk)
    c5 = kh + 1 - kh
    c6 = kh - kh + 1
    c7 = ka * kb * kc
    c8 = ka * (kb * kc)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0.1
    b = 0.2
    c = 0.3
    h = 1e308
    k = 10
    @assert r1 == 0.6000000000000001
    @assert r2 == 0.6
    @assert r3 == 1/0
    @assert r4 == 1e+308
    @assert 1 / r5 == 1/0
    @assert r6 == 1
    @assert r7 == 0.006000000000000001
    @assert r8 == 0.006
    @assert c1 == 0.6000000000000001
    @assert c2 == 0.6
    @assert c3 == 1/0
    @assert c4 == 1e+308
    @assert 1 / c5 == 1/0
    @assert c6 == 1
    @assert c7 == 0.006000000000000001
    @assert c8 == 0.006
    @stop
}
