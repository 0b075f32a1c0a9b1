spec 2.3  The largest I64 and U64 are read as the powers of two above them.

-- app.sm --
[state_vector]
U64 G
U32 S
I64 a
U64 b
F64 x
F64 y
F64 z
I64 c

[Run]
.step
    x = a
    y = b
    z = c

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1e30
    b = 1e30
    c = -1e30
    @assert x == 9223372036854775808
    @assert y == 18446744073709551616
    @assert z == -9223372036854775808
    @stop
}
