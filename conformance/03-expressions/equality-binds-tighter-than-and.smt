spec 3.5  a == b and c == d needs no parentheses.

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
F64  ka = 2 @read_only
F64  kb = 3 @read_only
F64  kc = 5 @read_only

[Run]
.step
    r1 = a == 2 and b == 3
    r2 = a == 2 and b
    r3 = b and a == 2
    r4 = 0 == a and b
    r5 = a and b == 1
    r6 = a != 2 and 0 != 1
    r7 = 1 and a != 3
    c1 = ka == 2 and kb == 3
    c2 = ka == 2 and kb
    c3 = kb and ka == 2
    c4 = 0 == ka and kb
    c5 = ka and kb == 1
    c6 = ka != 2 and 0 != 1
    c7 = 1 and ka != 3

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2
    b = 3
    c = 5
    @assert r1 == 1
    @assert r2 == 1
    @assert r3 == 1
    @assert 1 / r4 == 1/0
    @assert 1 / r5 == 1/0
    @assert 1 / r6 == 1/0
    @assert r7 == 1
    @assert c1 == 1
    @assert c2 == 1
    @assert c3 == 1
    @assert 1 / c4 == 1/0
    @assert 1 / c5 == 1/0
    @assert 1 / c6 == 1/0
    @assert c7 == 1
    @stop
}
