spec 2.6, 3.15  Arithmetic on whole numbers is F64 arithmetic: 0 - n is +0 and -n is −0 where n is 0, and n * -1 is −0.

-- app.sm --
[state_vector]
U64 G
U32 S
I32  n
U8   m
I8   k
bool b
I64  l
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
F64  r25
F64  r26
F64  r27
F64  r28
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
F64  c25
F64  c26
F64  c27
F64  c28

[local]
I32  kn = 0 @read_only
U8   km = 0 @read_only
I8   kk = -3 @read_only
bool kb = 0 @read_only
I64  kl = 0 @read_only

[Run]
.step
    r1 = 0 - n
    r2 = -n
    r3 = n * -1
    r4 = n * k
    r5 = m * k
    r6 = -m
    r7 = n - m
    r8 = -n - m
    r9 = -n + m
    r10 = m / k
    r11 = -b
    r12 = b * -5
    r13 = -l
    r14 = l * k
    r15 = n + -n
    r16 = -(n + m)
    r17 = -(n - m) * 2
    r18 = 0 * k
    r19 = (k + 3) * -2
    r20 = k + 3
    r21 = -(k + 3)
    r22 = abs(-n)
    r23 = floor(-n)
    r24 = min(n, -n)
    r25 = max(-n, m)
    r26 = sign(-n)
    r27 = -n * -1
    r28 = trunc(m * k)
    c1 = 0 - kn
    c2 = -kn
    c3 = kn * -1
    c4 = kn * kk
    c5 = km * kk
    c6 = -km
    c7 = kn - km
    c8 = -kn - km
    c9 = -kn + km
    c10 = km / kk
    c11 = -kb
    c12 = kb * -5
    c13 = -kl
    c14 = kl * kk
    c15 = kn + -kn
    c16 = -(kn + km)
    c17 = -(kn - km) * 2
    c18 = 0 * kk
    c19 = (kk + 3) * -2
    c20 = kk + 3
    c21 = -(kk + 3)
    c22 = abs(-kn)
    c23 = floor(-kn)
    c24 = min(kn, -kn)
    c25 = max(-kn, km)
    c26 = sign(-kn)
    c27 = -kn * -1
    c28 = trunc(km * kk)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    n = 0
    m = 0
    k = -3
    b = 0
    l = 0
    @assert 1 / r1 == 1/0
    @assert 1 / r2 == -1/0
    @assert 1 / r3 == -1/0
    @assert 1 / r4 == -1/0
    @assert 1 / r5 == -1/0
    @assert 1 / r6 == -1/0
    @assert 1 / r7 == 1/0
    @assert 1 / r8 == -1/0
    @assert 1 / r9 == 1/0
    @assert 1 / r10 == -1/0
    @assert 1 / r11 == -1/0
    @assert 1 / r12 == -1/0
    @assert 1 / r13 == -1/0
    @assert 1 / r14 == -1/0
    @assert 1 / r15 == 1/0
    @assert 1 / r16 == -1/0
    @assert 1 / r17 == -1/0
    @assert 1 / r18 == -1/0
    @assert 1 / r19 == -1/0
    @assert 1 / r20 == 1/0
    @assert 1 / r21 == -1/0
    @assert 1 / r22 == 1/0
    @assert 1 / r23 == -1/0
    @assert 1 / r24 == -1/0
    @assert 1 / r25 == 1/0
    @assert 1 / r26 == -1/0
    @assert 1 / r27 == 1/0
    @assert 1 / r28 == -1/0
    @assert 1 / c1 == 1/0
    @assert 1 / c2 == -1/0
    @assert 1 / c3 == -1/0
    @assert 1 / c4 == -1/0
    @assert 1 / c5 == -1/0
    @assert 1 / c6 == -1/0
    @assert 1 / c7 == 1/0
    @assert 1 / c8 == -1/0
    @assert 1 / c9 == 1/0
    @assert 1 / c10 == -1/0
    @assert 1 / c11 == -1/0
    @assert 1 / c12 == -1/0
    @assert 1 / c13 == -1/0
    @assert 1 / c14 == -1/0
    @assert 1 / c15 == 1/0
    @assert 1 / c16 == -1/0
    @assert 1 / c17 == -1/0
    @assert 1 / c18 == -1/0
    @assert 1 / c19 == -1/0
    @assert 1 / c20 == 1/0
    @assert 1 / c21 == -1/0
    @assert 1 / c22 == 1/0
    @assert 1 / c23 == -1/0
    @assert 1 / c24 == -1/0
    @assert 1 / c25 == 1/0
    @assert 1 / c26 == -1/0
    @assert 1 / c27 == 1/0
    @assert 1 / c28 == -1/0
    @stop
}
