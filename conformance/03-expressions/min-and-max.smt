spec 3.26  The smaller and the larger of two, infinities included.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  i
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
F64  ka = -2 @read_only
F64  kb = 3 @read_only
F64  ki = 1/0 @read_only

[Run]
.step
    r1 = min(a, b)
    r2 = max(a, b)
    r3 = min(b, a)
    r4 = max(b, a)
    r5 = min(i, a)
    r6 = max(-i, a)
    r7 = min(-i, a)
    r8 = max(b, i)
    r9 = min(b, b)
    r10 = max(a, a)
    c1 = min(ka, kb)
    c2 = max(ka, kb)
    c3 = min(kb, ka)
    c4 = max(kb, ka)
    c5 = min(ki, ka)
    c6 = max(-ki, ka)
    c7 = min(-ki, ka)
    c8 = max(kb, ki)
    c9 = min(kb, kb)
    c10 = max(ka, ka)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = -2
    b = 3
    i = 1/0
    @assert r1 == -2
    @assert r2 == 3
    @assert r3 == -2
    @assert r4 == 3
    @assert r5 == -2
    @assert r6 == -2
    @assert r7 == -1/0
    @assert r8 == 1/0
    @assert r9 == 3
    @assert r10 == -2
    @assert c1 == -2
    @assert c2 == 3
    @assert c3 == -2
    @assert c4 == 3
    @assert c5 == -2
    @assert c6 == -2
    @assert c7 == -1/0
    @assert c8 == 1/0
    @assert c9 == 3
    @assert c10 == -2
    @stop
}
