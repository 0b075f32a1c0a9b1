spec 3.7  Operators of one level are done from left to right.

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
F64  ka = 10 @read_only
F64  kb = 4 @read_only
F64  kc = 3 @read_only

[Run]
.step
    r1 = a - b - c
    r2 = 100 / a / 5
    r3 = a - b + c
    r4 = a / b * c
    r5 = a * b / c
    r6 = 2 * a / b * c
    r7 = a - b - c - 1
    r8 = 8 / 4 / 2
    r9 = 1 - a + b
    c1 = ka - kb - kc
    c2 = 100 / ka / 5
    c3 = ka - kb + kc
    c4 = ka / kb * kc
    c5 = ka * kb / kc
    c6 = 2 * ka / kb * kc
    c7 = ka - kb - kc - 1
    c8 = 8 / 4 / 2
    c9 = 1 - ka + kb

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 10
    b = 4
    c = 3
    @assert r1 == 3
    @assert r2 == 2
    @assert r3 == 9
    @assert r4 == 7.5
    @assert r5 == 13.333333333333334
    @assert r6 == 15
    @assert r7 == 2
    @assert r8 == 1
    @assert r9 == -5
    @assert c1 == 3
    @assert c2 == 2
    @assert c3 == 9
    @assert c4 == 7.5
    @assert c5 == 13.333333333333334
    @assert c6 == 15
    @assert c7 == 2
    @assert c8 == 1
    @assert c9 == -5
    @stop
}
