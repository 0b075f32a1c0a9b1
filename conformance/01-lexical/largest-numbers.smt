spec 1.18  What rounds down to the largest F64 is no error, nor a zero with a huge exponent.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 c

[Run]
.step
    a = 1.7976931348623157e308
    b = 1.797693134862315807e308
    c = 0e99999

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert a == b
    @assert a + a == 1/0
    @assert a - a == 0
    @assert c == 0
    @stop
}
