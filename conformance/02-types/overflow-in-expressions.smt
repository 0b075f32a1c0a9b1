spec 2.9, 2.6  What grows too large becomes an infinity and may come back into range only by further arithmetic.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  h
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
F64  kh = 1.7976931348623157e308 @read_only

[Run]
.step
    r1 = h + h
    r2 = -h * 2
    r3 = h + h - h
    r4 = 1 / (h * h)
    r5 = h + 1
    r6 = h + 1e292
    c1 = kh + kh
    c2 = -kh * 2
    c3 = kh + kh - kh
    c4 = 1 / (kh * kh)
    c5 = kh + 1
    c6 = kh + 1e292

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    h = 1.7976931348623157e308
    @assert r1 == 1/0
    @assert r2 == -1/0
    @assert r3 == 1/0
    @assert 1 / r4 == 1/0
    @assert r5 == 1.7976931348623157e+308
    @assert r6 == 1/0
    @assert c1 == 1/0
    @assert c2 == -1/0
    @assert c3 == 1/0
    @assert 1 / c4 == 1/0
    @assert c5 == 1.7976931348623157e+308
    @assert c6 == 1/0
    @stop
}
