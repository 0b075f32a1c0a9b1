spec 3.15  -x flips the sign, of zeros too; 0 - x does not.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  z
F64  n
F64  i
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
F64  r12
F64  r13
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

[local]
F64  kz = 0 @read_only
F64  kn = -0.0 @read_only
F64  ki = 1/0 @read_only
F64  kx = 2.5 @read_only

[Run]
.step
    r1 = -z
    r2 = -n
    r3 = 0 - z
    r4 = 0 - n
    r5 = -i
    r6 = -x
    r7 = -0.0
    r8 = -(z * x)
    r9 = -0
    r10 = - -z
    r11 = z - z
    r12 = -z + -z
    r13 = -z + z
    c1 = -kz
    c2 = -kn
    c3 = 0 - kz
    c4 = 0 - kn
    c5 = -ki
    c6 = -kx
    c7 = -0.0
    c8 = -(kz * kx)
    c9 = -0
    c10 = - -kz
    c11 = kz - kz
    c12 = -kz + -kz
    c13 = -kz + kz

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    n = -0.0
    i = 1/0
    x = 2.5
    @assert 1 / r1 == -1/0
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert 1 / r4 == 1/0
    @assert r5 == -1/0
    @assert r6 == -2.5
    @assert 1 / r7 == -1/0
    @assert 1 / r8 == -1/0
    @assert 1 / r9 == -1/0
    @assert 1 / r10 == 1/0
    @assert 1 / r11 == 1/0
    @assert 1 / r12 == -1/0
    @assert 1 / r13 == 1/0
    @assert 1 / c1 == -1/0
    @assert 1 / c2 == 1/0
    @assert 1 / c3 == 1/0
    @assert 1 / c4 == 1/0
    @assert c5 == -1/0
    @assert c6 == -2.5
    @assert 1 / c7 == -1/0
    @assert 1 / c8 == -1/0
    @assert 1 / c9 == -1/0
    @assert 1 / c10 == 1/0
    @assert 1 / c11 == 1/0
    @assert 1 / c12 == -1/0
    @assert 1 / c13 == 1/0
    @stop
}
