spec 1.17  A number is the nearest F64: 9007199254740993 is half-way between two and becomes the even one; one more digit decides.

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
    a = 9007199254740993
    b = 9007199254740993.0000000000000000000000000000000000001
    c = 9007199254740995
    d = 9007199254740992.9999999999999999999999999999
    e = 0x20000000000001

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert a == 9007199254740992
    @assert b == 9007199254740994
    @assert c == 9007199254740996
    @assert d == 9007199254740992
    @assert e == 9007199254740992
    @stop
}
