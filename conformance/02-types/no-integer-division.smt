spec 2.6  Dividing integers keeps the fraction; the sum of two U8 may exceed 255 inside an expression.

-- app.sm --
[state_vector]
U64 G
U32 S
U8   a
U8   b
U8   c
I8   d
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
U8   ka = 7 @read_only
U8   kb = 2 @read_only
U8   kc = 200 @read_only
I8   kd = -100 @read_only

[Run]
.step
    r1 = a / b
    r2 = c + c
    r3 = b - a
    r4 = d * d
    r5 = -a / b
    r6 = c * c * c * c * c
    c1 = ka / kb
    c2 = kc + kc
    c3 = kb - ka
    c4 = kd * kd
    c5 = -ka / kb
    c6 = kc * kc * kc * kc * kc

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 7
    b = 2
    c = 200
    d = -100
    @assert r1 == 3.5
    @assert r2 == 400
    @assert r3 == -5
    @assert r4 == 10000
    @assert r5 == -3.5
    @assert r6 == 320000000000
    @assert c1 == 3.5
    @assert c2 == 400
    @assert c3 == -5
    @assert c4 == 10000
    @assert c5 == -3.5
    @assert c6 == 320000000000
    @stop
}
