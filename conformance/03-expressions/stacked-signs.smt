spec 3.1  Operators before a value may be stacked, in any mix.

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
F64  r9
F64  r10
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

[local]
F64  ka = 2 @read_only
F64  kb = 0 @read_only

[Run]
.step
    r1 = - -a
    r2 = --a
    r3 = -+-+a
    r4 = not not a
    r5 = !!a
    r6 = -not a
    r7 = not -a
    r8 = -!b
    r9 = !-b
    r10 = a - - - a
    c1 = - -ka
    c2 = --ka
    c3 = -+-+ka
    c4 = not not ka
    c5 = !!ka
    c6 = -not ka
    c7 = not -ka
    c8 = -!kb
    c9 = !-kb
    c10 = ka - - - ka

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2
    b = 0
    @assert r1 == 2
    @assert r2 == 2
    @assert r3 == 2
    @assert r4 == 1
    @assert r5 == 1
    @assert 1 / r6 == -1/0
    @assert 1 / r7 == 1/0
    @assert r8 == -1
    @assert r9 == 1
    @assert 1 / r10 == 1/0
    @assert c1 == 2
    @assert c2 == 2
    @assert c3 == 2
    @assert c4 == 1
    @assert c5 == 1
    @assert 1 / c6 == -1/0
    @assert 1 / c7 == 1/0
    @assert c8 == -1
    @assert c9 == 1
    @assert 1 / c10 == 1/0
    @stop
}
