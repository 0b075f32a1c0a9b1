spec 3.2  a + b * c is a + (b * c), a * b + c is (a * b) + c, and for - and / alike.

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
    r1 = a + b * c
    r2 = a * b + c
    r3 = a - b / c
    r4 = a / b - c
    r5 = a - b * c
    r6 = a + b / c
    r7 = c * a - b * a
    r8 = 1 + a * b - c / 2 + 1
    c1 = ka + kb * kc
    c2 = ka * kb + kc
    c3 = ka - kb / kc
    c4 = ka / kb - kc
    c5 = ka - kb * kc
    c6 = ka + kb / kc
    c7 = kc * ka - kb * ka
    c8 = 1 + ka * kb - kc / 2 + 1

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2
    b = 3
    c = 5
    @assert r1 == 17
    @assert r2 == 11
    @assert r3 == 1.4
    @assert r4 == -4.333333333333333
    @assert r5 == -13
    @assert r6 == 2.6
    @assert r7 == 4
    @assert r8 == 5.5
    @assert c1 == 17
    @assert c2 == 11
    @assert c3 == 1.4
    @assert c4 == -4.333333333333333
    @assert c5 == -13
    @assert c6 == 2.6
    @assert c7 == 4
    @assert c8 == 5.5
    @stop
}
