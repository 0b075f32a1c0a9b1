spec 3.9, 3.3  The values of a chain may be sums.

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
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6

[local]
F64  ka = 1 @read_only
F64  kb = 2 @read_only
F64  kc = 3 @read_only

[Run]
.step
    r1 = a + a <= b < c + 1
    r2 = a * 2 < b * 2 < c * 2
    r3 = a < b - 1 < c
    r4 = a < b < c == true
    r5 = not (a < b < c)
    r6 = (a < b < c) + (c > b > a)
    c1 = ka + ka <= kb < kc + 1
    c2 = ka * 2 < kb * 2 < kc * 2
    c3 = ka < kb - 1 < kc
    c4 = ka < kb < kc == true
    c5 = not (ka < kb < kc)
    c6 = (ka < kb < kc) + (kc > kb > ka)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1
    b = 2
    c = 3
    @assert r1 == 1
    @assert r2 == 1
    @assert 1 / r3 == 1/0
    @assert r4 == 1
    @assert 1 / r5 == 1/0
    @assert r6 == 2
    @assert c1 == 1
    @assert c2 == 1
    @assert 1 / c3 == 1/0
    @assert c4 == 1
    @assert 1 / c5 == 1/0
    @assert c6 == 2
    @stop
}
