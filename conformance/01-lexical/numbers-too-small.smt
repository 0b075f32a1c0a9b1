spec 1.19  A number too small becomes a subnormal F64 or zero.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 c
F64 d
F64 e

[Run]
.step
    a = 1e-310
    b = 5e-324
    c = 2e-324
    d = 1e-400
    e = 1e-99999999999999999999

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert a > 0
    @assert a * 1e10 > 0.99e-300
    @assert b > 0
    @assert b / 2 == 0
    @assert c == 0
    @assert d == 0
    @assert e == 0
    @stop
}
