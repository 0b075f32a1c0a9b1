spec 2.7  a * b + c rounds the product and then the sum: 0.1 * 10 - 1 is 0 exactly.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  c
F64  d
F64  e
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5

[local]
F64  ka = 0.1 @read_only
F64  kb = 10 @read_only
F64  kc = 0.905 @read_only
F64  kd = 1.12 @read_only
F64  ke = -1.0136 @read_only

[Run]
.step
    r1 = a * b - 1
    r2 = c * d + e
    r3 = e + c * d
    r4 = 1 - a * b
    r5 = a * a - a * a
    c1 = ka * kb - 1
    c2 = kc * kd + ke
    c3 = ke + kc * kd
    c4 = 1 - ka * kb
    c5 = ka * ka - ka * ka

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0.1
    b = 10
    c = 0.905
    d = 1.12
    e = -1.0136
    @assert 1 / r1 == 1/0
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert 1 / r4 == 1/0
    @assert 1 / r5 == 1/0
    @assert 1 / c1 == 1/0
    @assert 1 / c2 == 1/0
    @assert 1 / c3 == 1/0
    @assert 1 / c4 == 1/0
    @assert 1 / c5 == 1/0
    @stop
}
