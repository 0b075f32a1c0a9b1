spec 3.9  A chain may have any length and mix all four comparisons.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  c
F64  d
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  r6
F64  r7
F64  r8
F64  r9
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6
F64  c7
F64  c8
F64  c9

[local]
F64  ka = 1 @read_only
F64  kb = 2 @read_only
F64  kc = 3 @read_only
F64  kd = 4 @read_only

[Run]
.step
    r1 = a < b < c < d
    r2 = a < b > a <= b >= b < c
    r3 = a < b < c > d
    r4 = a > b < c < d
    r5 = a < c < b < d
    r6 = a <= a <= a < b
    r7 = a < d > b < c
    r8 = d > a < c > b
    r9 = d >= d > c >= b > 1 >= a
    c1 = ka < kb < kc < kd
    c2 = ka < kb > ka <= kb >= kb < kc
    c3 = ka < kb < kc > kd
    c4 = ka > kb < kc < kd
    c5 = ka < kc < kb < kd
    c6 = ka <= ka <= ka < kb
    c7 = ka < kd > kb < kc
    c8 = kd > ka < kc > kb
    c9 = kd >= kd > kc >= kb > 1 >= ka

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1
    b = 2
    c = 3
    d = 4
    @assert r1 == 1
    @assert r2 == 1
    @assert 1 / r3 == 1/0
    @assert 1 / r4 == 1/0
    @assert 1 / r5 == 1/0
    @assert r6 == 1
    @assert r7 == 1
    @assert r8 == 1
    @assert r9 == 1
    @assert c1 == 1
    @assert c2 == 1
    @assert 1 / c3 == 1/0
    @assert 1 / c4 == 1/0
    @assert 1 / c5 == 1/0
    @assert c6 == 1
    @assert c7 == 1
    @assert c8 == 1
    @assert c9 == 1
    @stop
}
