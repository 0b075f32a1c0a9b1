spec 3.1  not reaches to the next value only: not a and b is (not a) and b.

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
F64  ka = 1 @read_only
F64  kb = 0 @read_only
F64  kc = 5 @read_only

[Run]
.step
    r1 = not b and b
    r2 = not (b and b)
    r3 = not a or a
    r4 = -1 + !b
    r5 = not b or a
    r6 = c * !b
    r7 = c * not b
    r8 = not b or b or b
    r9 = !b and !b
    c1 = not kb and kb
    c2 = not (kb and kb)
    c3 = not ka or ka
    c4 = -1 + !kb
    c5 = not kb or ka
    c6 = kc * !kb
    c7 = kc * not kb
    c8 = not kb or kb or kb
    c9 = !kb and !kb

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1
    b = 0
    c = 5
    @assert 1 / r1 == 1/0
    @assert r2 == 1
    @assert r3 == 1
    @assert 1 / r4 == 1/0
    @assert r5 == 1
    @assert r6 == 5
    @assert r7 == 5
    @assert r8 == 1
    @assert r9 == 1
    @assert 1 / c1 == 1/0
    @assert c2 == 1
    @assert c3 == 1
    @assert 1 / c4 == 1/0
    @assert c5 == 1
    @assert c6 == 5
    @assert c7 == 5
    @assert c8 == 1
    @assert c9 == 1
    @stop
}
