spec 3.7  and and or, repeated, take any number of values.

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
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6

[local]
F64  kt = 1 @read_only
F64  kf = 0 @read_only

[Run]
.step
    r1 = t and t and t and f
    r2 = t and t and t and t
    r3 = f or f or f or t
    r4 = f or f or f
    r5 = (t == t) == t
    r6 = (f != f) != t
    c1 = kt and kt and kt and kf
    c2 = kt and kt and kt and kt
    c3 = kf or kf or kf or kt
    c4 = kf or kf or kf
    c5 = (kt == kt) == kt
    c6 = (kf != kf) != kt

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    t = 1
    f = 0
    @assert 1 / r1 == 1/0
    @assert r2 == 1
    @assert r3 == 1
    @assert 1 / r4 == 1/0
    @assert r5 == 1
    @assert r6 == 1
    @assert 1 / c1 == 1/0
    @assert c2 == 1
    @assert c3 == 1
    @assert 1 / c4 == 1/0
    @assert c5 == 1
    @assert c6 == 1
    @stop
}
