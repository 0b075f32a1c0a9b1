spec 3.4  a < b == c < d compares two truth values, in either order.

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
    r1 = a < b == b < c
    r2 = a > b == b > c
    r3 = a == b < c
    r4 = 1 == b < c
    r5 = 5 != c > 1
    r6 = a < b != c
    r7 = c > b == a
    r8 = c > b == true
    c1 = ka < kb == kb < kc
    c2 = ka > kb == kb > kc
    c3 = ka == kb < kc
    c4 = 1 == kb < kc
    c5 = 5 != kc > 1
    c6 = ka < kb != kc
    c7 = kc > kb == ka
    c8 = kc > kb == true

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2
    b = 3
    c = 5
    @assert r1 == 1
    @assert r2 == 1
    @assert 1 / r3 == 1/0
    @assert r4 == 1
    @assert r5 == 1
    @assert r6 == 1
    @assert 1 / r7 == 1/0
    @assert r8 == 1
    @assert c1 == 1
    @assert c2 == 1
    @assert 1 / c3 == 1/0
    @assert c4 == 1
    @assert c5 == 1
    @assert c6 == 1
    @assert 1 / c7 == 1/0
    @assert c8 == 1
    @stop
}
