spec 1.17, 1.13  Hexadecimal numbers of more than 53 bits are rounded to the nearest, half to even.

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
    a = 0x20000000000001
    b = 0x20000000000003
    c = 0x200000000000010000000000000001
    d = 0xFFFFFFFFFFFFFFFF

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert a == 9007199254740992
    @assert b == 9007199254740996
    @assert d == 18446744073709551616
    @stop
}

-- trace --
1 a 0x1p+53
1 b 0x1.0000000000002p+53
1 c 0x1.0000000000001p+117
1 d 0x1p+64
