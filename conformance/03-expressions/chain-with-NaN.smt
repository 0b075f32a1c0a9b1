spec 3.9, 2.11  A chain with NaN anywhere is false.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  z
F64  a
F64  b
F64  r1
F64  r2
F64  r3
F64  r4
F64  c1
F64  c2
F64  c3
F64  c4

[local]
F64  kz = 0 @read_only
F64  ka = 1 @read_only
F64  kb = 2 @read_only

[Run]
.step
    r1 = a < z / z < b
    r2 = z / z < a < b
    r3 = a < b < z / z
    r4 = not (a < z / z < b)
    c1 = ka < kz / kz < kb
    c2 = kz / kz < ka < kb
    c3 = ka < kb < kz / kz
    c4 = not (ka < kz / kz < kb)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    a = 1
    b = 2
    @assert 1 / r1 == 1/0
    @assert 1 / r2 == 1/0
    @assert 1 / r3 == 1/0
    @assert r4 == 1
    @assert 1 / c1 == 1/0
    @assert 1 / c2 == 1/0
    @assert 1 / c3 == 1/0
    @assert c4 == 1
    @stop
}
