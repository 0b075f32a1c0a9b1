spec 3.3  a < b + c is a < (b + c).

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
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6
F64  c7
F64  c8

[local]
F64  ka = 2 @read_only
F64  kb = 3 @read_only
F64  kc = 5 @read_only

[Run]
.step
    r1 = a < b + c
    r2 = c > a + 4
    r3 = a + b <= c
    r4 = c - a >= b
    r5 = c - 2 > b
    r6 = 1 + (a < b)
    r7 = a + b < c + 1
    r8 = 5 - a > 2
    c1 = ka < kb + kc
    c2 = kc > ka + 4
    c3 = ka + kb <= kc
    c4 = kc - ka >= kb
    c5 = kc - 2 > kb
    c6 = 1 + (ka < kb)
    c7 = ka + kb < kc + 1
    c8 = 5 - ka > 2

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2
    b = 3
    c = 5
    @assert r1 == 1
    @assert 1 / r2 == 1/0
    @assert r3 == 1
    @assert r4 == 1
    @assert 1 / r5 == 1/0
    @assert r6 == 2
    @assert r7 == 1
    @assert r8 == 1
    @assert c1 == 1
    @assert 1 / c2 == 1/0
    @assert c3 == 1
    @assert c4 == 1
    @assert 1 / c5 == 1/0
    @assert c6 == 2
    @assert c7 == 1
    @assert c8 == 1
    @stop
}
