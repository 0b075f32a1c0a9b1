spec 3.6  a or b and c is a or (b and c); a and b or c is (a and b) or c.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  t
F64  f
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
F64  kt = 1 @read_only
F64  kf = 0 @read_only

[Run]
.step
    r1 = t or f and f
    r2 = (t or f) and f
    r3 = f and f or t
    r4 = f and (f or t)
    r5 = t or t and f
    r6 = f and t or t and t
    r7 = t or f and f or f
    c1 = kt or kf and kf
    c2 = (kt or kf) and kf
    c3 = kf and kf or kt
    c4 = kf and (kf or kt)
    c5 = kt or kt and kf
    c6 = kf and kt or kt and kt
    c7 = kt or kf and kf or kf

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    t = 1
    f = 0
    @assert r1 == 1
    @assert 1 / r2 == 1/0
    @assert r3 == 1
    @assert 1 / r4 == 1/0
    @assert r5 == 1
    @assert r6 == 1
    @assert r7 == 1
    @assert c1 == 1
    @assert 1 / c2 == 1/0
    @assert c3 == 1
    @assert 1 / c4 == 1/0
    @assert c5 == 1
    @assert c6 == 1
    @assert c7 == 1
    @stop
}
