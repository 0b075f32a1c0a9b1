spec 1.10  Capital and small letters differ: p and P are two elements, True and IF are ordinary names.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 P
F64 True
F64 IF
F64 Not
F64 u8

[Run]
.step
    p = 1
    P = 2
    True = 3
    IF = 4
    Not = 5
    u8 = 6

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert p == 1
    @assert P == 2
    @assert True == 3
    @assert IF == 4
    @assert Not == 5
    @assert u8 == 6
    @stop
}
