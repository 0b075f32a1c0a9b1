spec 2.10  A comparison or a logical operation gives 1 or 0, for operands of any size.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
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
F64  ka = 7 @read_only
F64  kb = -0.25 @read_only

[Run]
.step
    r1 = (a > b) + (a >= a) + (b < a) + (b <= b)
    r2 = (a == a) * 10 + (a != a)
    r3 = a and b
    r4 = a or 0
    r5 = not a
    r6 = not 0
    r7 = (a and b) + (a and 0)
    r8 = 5 + !b
    c1 = (ka > kb) + (ka >= ka) + (kb < ka) + (kb <= kb)
    c2 = (ka == ka) * 10 + (ka != ka)
    c3 = ka and kb
    c4 = ka or 0
    c5 = not ka
    c6 = not 0
    c7 = (ka and kb) + (ka and 0)
    c8 = 5 + !kb

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 7
    b = -0.25
    @assert r1 == 4
    @assert r2 == 10
    @assert r3 == 1
    @assert r4 == 1
    @assert 1 / r5 == 1/0
    @assert r6 == 1
    @assert r7 == 1
    @assert r8 == 5
    @assert c1 == 4
    @assert c2 == 10
    @assert c3 == 1
    @assert c4 == 1
    @assert 1 / c5 == 1/0
    @assert c6 == 1
    @assert c7 == 1
    @assert c8 == 5
    @stop
}
