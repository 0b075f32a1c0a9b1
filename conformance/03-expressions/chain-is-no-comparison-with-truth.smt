spec 3.9  1 < 5 < 4 is false, though (1 < 5) is 1 and 1 < 4; 3 > 2 > 1 is true, though 1 > 1 is not.

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
F64  kb = 5 @read_only
F64  kc = 4 @read_only

[Run]
.step
    r1 = a < b < c
    r2 = 3 > 2 > a
    r3 = -1 < -a < 0
    r4 = 0 < 0.5 < 1
    r5 = c < b > a
    r6 = 9 > b > c > 2 > a
    c1 = ka < kb < kc
    c2 = 3 > 2 > ka
    c3 = -1 < -ka < 0
    c4 = 0 < 0.5 < 1
    c5 = kc < kb > ka
    c6 = 9 > kb > kc > 2 > ka

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1
    b = 5
    c = 4
    @assert 1 / r1 == 1/0
    @assert r2 == 1
    @assert 1 / r3 == 1/0
    @assert r4 == 1
    @assert r5 == 1
    @assert r6 == 1
    @assert 1 / c1 == 1/0
    @assert c2 == 1
    @assert 1 / c3 == 1/0
    @assert c4 == 1
    @assert c5 == 1
    @assert c6 == 1
    @stop
}
