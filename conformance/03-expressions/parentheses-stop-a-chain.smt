spec 3.10  (3 < 5) < 4 is 1 < 4, and 3 < (5 < 4) is 3 < 0.

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
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6
F64  c7

[local]
F64  ka = 3 @read_only
F64  kb = 5 @read_only
F64  kc = 4 @read_only

[Run]
.step
    r1 = (a < b) < c
    r2 = a < (b < c)
    r3 = a < b < c
    r4 = (b > c) > 0.5
    r5 = (b > c) > a
    r6 = (b > c > a) < 2
    r7 = (a < b) <= (c < b)
    c1 = (ka < kb) < kc
    c2 = ka < (kb < kc)
    c3 = ka < kb < kc
    c4 = (kb > kc) > 0.5
    c5 = (kb > kc) > ka
    c6 = (kb > kc > ka) < 2
    c7 = (ka < kb) <= (kc < kb)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 3
    b = 5
    c = 4
    @assert r1 == 1
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert r4 == 1
    @assert 1 / r5 == 1/0
    @assert r6 == 1
    @assert r7 == 1
    @assert c1 == 1
    @assert 1 / c2 == 1/0
    @assert 1 / c3 == 1/0
    @assert c4 == 1
    @assert 1 / c5 == 1/0
    @assert c6 == 1
    @assert c7 == 1
    @stop
}
