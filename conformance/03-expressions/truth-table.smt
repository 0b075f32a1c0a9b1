spec 3.14  and, or and not for all combinations.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  t
F64  f
F64  g
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  r6
F64  r7
F64  r8
F64  r9
F64  r10
F64  r11
F64  r12
F64  r13
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6
F64  c7
F64  c8
F64  c9
F64  c10
F64  c11
F64  c12
F64  c13

[local]
F64  kt = 1 @read_only
F64  kf = 0 @read_only
F64  kg = -2.5 @read_only

[Run]
.step
    r1 = t and t
    r2 = t and f
    r3 = f and t
    r4 = f and f
    r5 = t or t
    r6 = t or f
    r7 = f or t
    r8 = f or f
    r9 = not t
    r10 = not f
    r11 = g and g
    r12 = f or g
    r13 = not g
    c1 = kt and kt
    c2 = kt and kf
    c3 = kf and kt
    c4 = kf and kf
    c5 = kt or kt
    c6 = kt or kf
    c7 = kf or kt
    c8 = kf or kf
    c9 = not kt
    c10 = not kf
    c11 = kg and kg
    c12 = kf or kg
    c13 = not kg

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    t = 1
    f = 0
    g = -2.5
    @assert r1 == 1
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert 1 / r4 == 1/0
    @assert r5 == 1
    @assert r6 == 1
    @assert r7 == 1
    @assert 1 / r8 == 1/0
    @assert 1 / r9 == 1/0
    @assert r10 == 1
    @assert r11 == 1
    @assert r12 == 1
    @assert 1 / r13 == 1/0
    @assert c1 == 1
    @assert 1 / c2 == 1/0
    @assert 1 / c3 == 1/0
    @assert 1 / c4 == 1/0
    @assert c5 == 1
    @assert c6 == 1
    @assert c7 == 1
    @assert 1 / c8 == 1/0
    @assert 1 / c9 == 1/0
    @assert c10 == 1
    @assert c11 == 1
    @assert c12 == 1
    @assert 1 / c13 == 1/0
    @stop
}
