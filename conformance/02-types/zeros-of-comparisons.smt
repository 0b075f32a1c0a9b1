spec 2.10, 3.15  A false comparison is +0, and its negative is −0.

-- app.sm --
[state_vector]
U64 G
U32 S
I32  n
F64  x
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

[local]
I32  kn = 2 @read_only
F64  kx = 3 @read_only

[Run]
.step
    r1 = (n > 5)
    r2 = -(n > 5)
    r3 = (n > 5) * -1
    r4 = (x < n) - (n > x)
    r5 = -(x < n) - (n > x)
    r6 = not n
    r7 = -!n
    r8 = (n and 0) * -x
    r9 = (n > 1) - (x > 1)
    r10 = (n > 1) + (x > 1) + (n > 1)
    r11 = (n > 1) * -(x > 5)
    c1 = (kn > 5)
    c2 = -(kn > 5)
    c3 = (kn > 5) * -1
    c4 = (kx < kn) - (kn > kx)
    c5 = -(kx < kn) - (kn > kx)
    c6 = not kn
    c7 = -!kn
    c8 = (kn and 0) * -kx
    c9 = (kn > 1) - (kx > 1)
    c10 = (kn > 1) + (kx > 1) + (kn > 1)
    c11 = (kn > 1) * -(kx > 5)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    n = 2
    x = 3
    @assert 1 / r1 == 1/0
    @assert 1 / r2 == -1/0
    @assert 1 / r3 == -1/0
    @assert 1 / r4 == 1/0
    @assert 1 / r5 == -1/0
    @assert 1 / r6 == 1/0
    @assert 1 / r7 == -1/0
    @assert 1 / r8 == -1/0
    @assert 1 / r9 == 1/0
    @assert r10 == 3
    @assert 1 / r11 == -1/0
    @assert 1 / c1 == 1/0
    @assert 1 / c2 == -1/0
    @assert 1 / c3 == -1/0
    @assert 1 / c4 == 1/0
    @assert 1 / c5 == -1/0
    @assert 1 / c6 == 1/0
    @assert 1 / c7 == -1/0
    @assert 1 / c8 == -1/0
    @assert 1 / c9 == 1/0
    @assert c10 == 3
    @assert 1 / c11 == -1/0
    @stop
}
