spec 2.20  Subnormal F32 values are stored, and −0 stays −0.

-- app.sm --
[state_vector]
U64 G
U32 S
F32 a
F32 b
F32 c
F64 x

[Run]
.step
    a = x
    b = -x * 1e-10
    c = -0.0 * x

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 1e-45
    @assert a > 0
    @assert a == 1.401298464324817e-45
    @assert 1 / b == -1/0
    @assert 1 / c == -1/0
    @stop
}
