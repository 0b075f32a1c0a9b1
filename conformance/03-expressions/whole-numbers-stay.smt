spec 3.29  Whole numbers of any size, infinities and −0 are given back as they are.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  i
F64  z
F64  w
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
F64  r11
F64  r12
F64  r13
F64  r14
F64  r15
F64  r16
F64  r17
F64  r18
F64  r19
F64  r20
F64  r21
F64  r22
F64  r23
F64  r24
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
F64  c11
F64  c12
F64  c13
F64  c14
F64  c15
F64  c16
F64  c17
F64  c18
F64  c19
F64  c20
F64  c21
F64  c22
F64  c23
F64  c24

[local]
F64  ka = 1e300 @read_only
F64  kb = -9007199254740993 @read_only
F64  ki = 1/0 @read_only
F64  kz = -0.0 @read_only
F64  kw = -7 @read_only

[Run]
.step
    r1 = floor(a)
    r2 = floor(b)
    r3 = floor(i)
    r4 = floor(-i)
    r5 = floor(z)
    r6 = floor(w)
    r7 = ceil(a)
    r8 = ceil(b)
    r9 = ceil(i)
    r10 = ceil(-i)
    r11 = ceil(z)
    r12 = ceil(w)
    r13 = trunc(a)
    r14 = trunc(b)
    r15 = trunc(i)
    r16 = trunc(-i)
    r17 = trunc(z)
    r18 = trunc(w)
    r19 = round(a)
    r20 = round(b)
    r21 = round(i)
    r22 = round(-i)
    r23 = round(z)
    r24 = round(w)
    c1 = floor(ka)
    c2 = floor(kb)
    c3 = floor(ki)
    c4 = floor(-ki)
    c5 = floor(kz)
    c6 = floor(kw)
    c7 = ceil(ka)
    c8 = ceil(kb)
    c9 = ceil(ki)
    c10 = ceil(-ki)
    c11 = ceil(kz)
    c12 = ceil(kw)
    c13 = trunc(ka)
    c14 = trunc(kb)
    c15 = trunc(ki)
    c16 = trunc(-ki)
    c17 = trunc(kz)
    c18 = trunc(kw)
    c19 = round(ka)
    c20 = round(kb)
    c21 = round(ki)
    c22 = round(-ki)
    c23 = round(kz)
    c24 = round(kw)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1e300
    b = -9007199254740993
    i = 1/0
    z = -0.0
    w = -7
    @assert r1 == 1e+300
    @assert r2 == -9007199254740992.0
    @assert r3 == 1/0
    @assert r4 == -1/0
    @assert 1 / r5 == -1/0
    @assert r6 == -7
    @assert r7 == 1e+300
    @assert r8 == -9007199254740992.0
    @assert r9 == 1/0
    @assert r10 == -1/0
    @assert 1 / r11 == -1/0
    @assert r12 == -7
    @assert r13 == 1e+300
    @assert r14 == -9007199254740992.0
    @assert r15 == 1/0
    @assert r16 == -1/0
    @assert 1 / r17 == -1/0
    @assert r18 == -7
    @assert r19 == 1e+300
    @assert r20 == -9007199254740992.0
    @assert r21 == 1/0
    @assert r22 == -1/0
    @assert 1 / r23 == -1/0
    @assert r24 == -7
    @assert c1 == 1e+300
    @assert c2 == -9007199254740992.0
    @assert c3 == 1/0
    @assert c4 == -1/0
    @assert 1 / c5 == -1/0
    @assert c6 == -7
    @assert c7 == 1e+300
    @assert c8 == -9007199254740992.0
    @assert c9 == 1/0
    @assert c10 == -1/0
    @assert 1 / c11 == -1/0
    @assert c12 == -7
    @assert c13 == 1e+300
    @assert c14 == -9007199254740992.0
    @assert c15 == 1/0
    @assert c16 == -1/0
    @assert 1 / c17 == -1/0
    @assert c18 == -7
    @assert c19 == 1e+300
    @assert c20 == -9007199254740992.0
    @assert c21 == 1/0
    @assert c22 == -1/0
    @assert 1 / c23 == -1/0
    @assert c24 == -7
    @stop
}
