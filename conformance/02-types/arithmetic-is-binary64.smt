spec 2.6  Each operation is rounded to the nearest F64: 0.1 + 0.2 is not 0.3.

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
F64  kc = 3 @read_only
F64  kd = 9007199254740992 @read_only

[Run]
.step
    r1 = a + b
    r2 = a * c
    r3 = a / c
    r4 = d + 1
    r5 = d + 1 + 1
    r6 = d + c
    r7 = b - a * c
    r8 = d - a
    c1 = ka + kb
    c2 = ka * kc
    c3 = ka / kc
    c4 = kd + 1
    c5 = kd + 1 + 1
    c6 = kd + kc
    c7 = kb - ka * kc
    c8 = kd - ka

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0.1
    b = 0.2
    c = 3
    d = 9007199254740992
    @assert r1 == 0.30000000000000004
    @assert r2 == 0.30000000000000004
    @assert r3 == 0.03333333333333333
    @assert r4 == 9007199254740992.0
    @assert r5 == 9007199254740992.0
    @assert r6 == 9007199254740996.0
    @assert r7 == -0.10000000000000003
    @assert r8 == 9007199254740992.0
    @assert c1 == 0.30000000000000004
    @assert c2 == 0.30000000000000004
    @assert c3 == 0.03333333333333333
    @assert c4 == 9007199254740992.0
    @assert c5 == 9007199254740992.0
    @assert c6 == 9007199254740996.0
    @assert c7 == -0.10000000000000003
    @assert c8 == 9007199254740992.0
    @stop
}
