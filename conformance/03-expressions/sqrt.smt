spec 3.24  sqrt is rounded to the nearest F64.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  c
F64  d
F64  e
F64  f
F64  g
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
F64  kb = 16 @read_only
F64  kc = 0.1 @read_only
F64  kd = 5e-324 @read_only
F64  ke = 1.7976931348623157e308 @read_only
F64  kf = 0.9999999999999999 @read_only
F64  kg = 9007199254740991 @read_only

[Run]
.step
    r1 = sqrt(a)
    r2 = sqrt(b)
    r3 = sqrt(c)
    r4 = sqrt(d)
    r5 = sqrt(e)
    r6 = sqrt(f)
    r7 = sqrt(g)
    r8 = sqrt(3)
    c1 = sqrt(ka)
    c2 = sqrt(kb)
    c3 = sqrt(kc)
    c4 = sqrt(kd)
    c5 = sqrt(ke)
    c6 = sqrt(kf)
    c7 = sqrt(kg)
    c8 = sqrt(3)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2
    b = 16
    c = 0.1
    d = 5e-324
    e = 1.7976931348623157e308
    f = 0.9999999999999999
    g = 9007199254740991
    @assert r1 == 1.4142135623730951
    @assert r2 == 4
    @assert r3 == 0.31622776601683794
    @assert r4 == 2.2227587494850775e-162
    @assert r5 == 1.3407807929942596e+154
    @assert r6 == 0.9999999999999999
    @assert r7 == 94906265.62425154
    @assert r8 == 1.7320508075688772
    @assert c1 == 1.4142135623730951
    @assert c2 == 4
    @assert c3 == 0.31622776601683794
    @assert c4 == 2.2227587494850775e-162
    @assert c5 == 1.3407807929942596e+154
    @assert c6 == 0.9999999999999999
    @assert c7 == 94906265.62425154
    @assert c8 == 1.7320508075688772
    @stop
}
