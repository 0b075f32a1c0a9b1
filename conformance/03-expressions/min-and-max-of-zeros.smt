spec 3.27  −0 is smaller than 0, in either order.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  z
F64  n
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
F64  kz = 0 @read_only
F64  kn = -0.0 @read_only

[Run]
.step
    r1 = min(z, n)
    r2 = min(n, z)
    r3 = max(z, n)
    r4 = max(n, z)
    r5 = min(n, n)
    r6 = max(n, n)
    r7 = min(z, z)
    c1 = min(kz, kn)
    c2 = min(kn, kz)
    c3 = max(kz, kn)
    c4 = max(kn, kz)
    c5 = min(kn, kn)
    c6 = max(kn, kn)
    c7 = min(kz, kz)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    n = -0.0
    @assert 1 / r1 == -1/0
    @assert 1 / r2 == -1/0
    @assert 1 / r3 == 1/0
    @assert 1 / r4 == 1/0
    @assert 1 / r5 == -1/0
    @assert 1 / r6 == -1/0
    @assert 1 / r7 == 1/0
    @assert 1 / c1 == -1/0
    @assert 1 / c2 == -1/0
    @assert 1 / c3 == 1/0
    @assert 1 / c4 == 1/0
    @assert 1 / c5 == -1/0
    @assert 1 / c6 == -1/0
    @assert 1 / c7 == 1/0
    @stop
}
