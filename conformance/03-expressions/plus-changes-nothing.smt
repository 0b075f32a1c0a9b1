spec 3.16  +x is x, −0 included.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  z
F64  n
F64  x
F64  r1
F64  r2
F64  r3
F64  r4
F64  r5
F64  r6
F64  c1
F64  c2
F64  c3
F64  c4
F64  c5
F64  c6

[local]
F64  kz = 0 @read_only
F64  kn = -0.0 @read_only
F64  kx = -2.5 @read_only

[Run]
.step
    r1 = +n
    r2 = +z
    r3 = +x
    r4 = + +x
    r5 = +-x
    r6 = -+n
    c1 = +kn
    c2 = +kz
    c3 = +kx
    c4 = + +kx
    c5 = +-kx
    c6 = -+kn

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    n = -0.0
    x = -2.5
    @assert 1 / r1 == -1/0
    @assert 1 / r2 == 1/0
    @assert r3 == -2.5
    @assert r4 == -2.5
    @assert r5 == 2.5
    @assert 1 / r6 == 1/0
    @assert 1 / c1 == -1/0
    @assert 1 / c2 == 1/0
    @assert c3 == -2.5
    @assert c4 == -2.5
    @assert c5 == 2.5
    @assert 1 / c6 == 1/0
    @stop
}
