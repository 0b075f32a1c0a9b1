spec 1.13  Hexadecimal digits may be capital or small; e is a digit, no exponent.

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
    a = 0x1F
    b = 0xabcDEF
    c = 0x0
    d = 0X1e3
    e = 0x00ff

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert a == 31
    @assert b == 11259375
    @assert c == 0
    @assert d == 483
    @assert e == 255
    @stop
}
