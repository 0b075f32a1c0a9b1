spec 2.16  A difference below zero is stored as 0 in an unsigned type.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 a
U16 b
U32 c
U64 d
U8 x

[Run]
.step
    a = x - 6
    b = x - 6
    c = x - 6
    d = x - 6

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 5
    a = 1
    b = 1
    c = 1
    d = 1
    @assert a == 0
    @assert b == 0
    @assert c == 0
    @assert d == 0
    @stop
}
