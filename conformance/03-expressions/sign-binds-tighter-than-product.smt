spec 3.1  -a * b is (-a) * b, and -a / b too: seen in the sign of a zero that is multiplied.

-- app.sm --
[state_vector]
U64 G
U32 S
F64  a
F64  b
F64  c
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
F64  ka = 0 @read_only
F64  kb = 3 @read_only
F64  kc = 5 @read_only

[Run]
.step
    r1 = -c * b
    r2 = -a * b
    r3 = c * -b
    r4 = c / -b
    r5 = -c + b
    r6 = c - -b
    r7 = -(c + b)
    c1 = -kc * kb
    c2 = -ka * kb
    c3 = kc * -kb
    c4 = kc / -kb
    c5 = -kc + kb
    c6 = kc - -kb
    c7 = -(kc + kb)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0
    b = 3
    c = 5
    @assert r1 == -15
    @assert 1 / r2 == -1/0
    @assert r3 == -15
    @assert r4 == -1.6666666666666667
    @assert r5 == -2
    @assert r6 == 8
    @assert r7 == -8
    @assert c1 == -15
    @assert 1 / c2 == -1/0
    @assert c3 == -15
    @assert c4 == -1.6666666666666667
    @assert c5 == -2
    @assert c6 == 8
    @assert c7 == -8
    @stop
}
