spec 3.9  500 < p < 825 is true between the two numbers, not at them.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  p
F64  q
F64  r
F64  s
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
F64  kp = 600 @read_only
F64  kq = 500 @read_only
F64  kr = 825 @read_only
F64  ks = 900 @read_only

[Run]
.step
    r1 = 500 < p < 825
    r2 = 500 < q < 825
    r3 = 500 < r < 825
    r4 = 500 < s < 825
    r5 = 500 <= q < 825
    r6 = 500 < r <= 825
    r7 = 500 < 0 - p < 825
    c1 = 500 < kp < 825
    c2 = 500 < kq < 825
    c3 = 500 < kr < 825
    c4 = 500 < ks < 825
    c5 = 500 <= kq < 825
    c6 = 500 < kr <= 825
    c7 = 500 < 0 - kp < 825

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    p = 600
    q = 500
    r = 825
    s = 900
    @assert r1 == 1
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert 1 / r4 == 1/0
    @assert r5 == 1
    @assert r6 == 1
    @assert 1 / r7 == 1/0
    @assert c1 == 1
    @assert 1 / c2 == 1/0
    @assert 1 / c3 == 1/0
    @assert 1 / c4 == 1/0
    @assert c5 == 1
    @assert c6 == 1
    @assert 1 / c7 == 1/0
    @stop
}
