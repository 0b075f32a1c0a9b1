spec 2.6  Two F32 are added, multiplied and divided as F64 values.

-- app.sm --
[state_vector]
U64 G
U32 S
F32  a
F32  b
F64  r1
F64  r2
F64  r3
F64  r4
F64  c1
F64  c2
F64  c3
F64  c4

[local]
F32  ka = 16777216 @read_only
F32  kb = 3 @read_only

[Run]
.step
    r1 = a + 1
    r2 = a / b
    r3 = 1 / b
    r4 = a * a * a
    c1 = ka + 1
    c2 = ka / kb
    c3 = 1 / kb
    c4 = ka * ka * ka

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 16777216
    b = 3
    @assert r1 == 16777217
    @assert r2 == 5592405.333333333
    @assert r3 == 0.3333333333333333
    @assert r4 == 4.722366482869645e+21
    @assert c1 == 16777217
    @assert c2 == 5592405.333333333
    @assert c3 == 0.3333333333333333
    @assert c4 == 4.722366482869645e+21
    @stop
}
