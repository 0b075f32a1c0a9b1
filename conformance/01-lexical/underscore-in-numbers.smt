spec 1.14  An underscore between two digits is left out, in fractions, exponents and hexadecimal numbers too.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 c
F64 d

[Run]
.step
    a = 1_000
    b = 1_2.3_4
    c = 1e1_0
    d = 0xF_F

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert a == 1000
    @assert b == 12.34
    @assert c == 10000000000
    @assert d == 255
    @stop
}
