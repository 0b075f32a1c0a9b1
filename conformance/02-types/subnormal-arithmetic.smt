spec 2.6  Results too small for a normal F64 are subnormal and rounded once, not flushed to zero.

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
F64  ka = 2.2250738585072014e-308 @read_only
F64  kb = 3 @read_only
F64  kc = 5e-324 @read_only

[Run]
.step
    r1 = a / 2
    r2 = a / b
    r3 = c * 0.75
    r4 = c / 2
    r5 = c * 1.5
    r6 = -c / 4
    r7 = a - a / b
    c1 = ka / 2
    c2 = ka / kb
    c3 = kc * 0.75
    c4 = kc / 2
    c5 = kc * 1.5
    c6 = -kc / 4
    c7 = ka - ka / kb

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2.2250738585072014e-308
    b = 3
    c = 5e-324
    @assert r1 == 1.1125369292536007e-308
    @assert r2 == 7.41691286169067e-309
    @assert r3 == 5e-324
    @assert 1 / r4 == 1/0
    @assert r5 == 1e-323
    @assert 1 / r6 == -1/0
    @assert r7 == 1.4833825723381344e-308
    @assert c1 == 1.1125369292536007e-308
    @assert c2 == 7.41691286169067e-309
    @assert c3 == 5e-324
    @assert 1 / c4 == 1/0
    @assert c5 == 1e-323
    @assert 1 / c6 == -1/0
    @assert c7 == 1.4833825723381344e-308
    @stop
}
