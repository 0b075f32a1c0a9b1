spec 3.11  With parentheses two equalities are allowed: a truth is compared.

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
F64  c1
F64  c2
F64  c3
F64  c4

[local]
F64  ka = 3 @read_only
F64  kb = 3 @read_only
F64  kc = 1 @read_only

[Run]
.step
    r1 = (a == b) == c
    r2 = a == (b == c)
    r3 = a == b and b == c
    r4 = (a != b) == (b != a)
    c1 = (ka == kb) == kc
    c2 = ka == (kb == kc)
    c3 = ka == kb and kb == kc
    c4 = (ka != kb) == (kb != ka)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 3
    b = 3
    c = 1
    @assert r1 == 1
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert r4 == 1
    @assert c1 == 1
    @assert 1 / c2 == 1/0
    @assert 1 / c3 == 1/0
    @assert c4 == 1
    @stop
}
