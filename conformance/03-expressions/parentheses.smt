spec 3.8  Parentheses are done first, and may be nested.

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
    r1 = (a + b) * c
    r2 = a * (b + c)
    r3 = c - (b - a)
    r4 = ((((a))))
    r5 = ((a + b) * (c - a)) / (b - (a - 1))
    r6 = -(a - b)
    r7 = (a)
    r8 = 2 - (3 - (4 - (5 - 6)))
    c1 = (ka + kb) * kc
    c2 = ka * (kb + kc)
    c3 = kc - (kb - ka)
    c4 = ((((ka))))
    c5 = ((ka + kb) * (kc - ka)) / (kb - (ka - 1))
    c6 = -(ka - kb)
    c7 = (ka)
    c8 = 2 - (3 - (4 - (5 - 6)))

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2
    b = 3
    c = 5
    @assert r1 == 25
    @assert r2 == 16
    @assert r3 == 4
    @assert r4 == 2
    @assert r5 == 7.5
    @assert r6 == 1
    @assert r7 == 2
    @assert r8 == 4
    @assert c1 == 25
    @assert c2 == 16
    @assert c3 == 4
    @assert c4 == 2
    @assert c5 == 7.5
    @assert c6 == 1
    @assert c7 == 2
    @assert c8 == 4
    @stop
}
