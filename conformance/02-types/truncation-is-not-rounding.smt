spec 2.15  2.75 is stored as 2.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 a
I32 b
U64 c
F64 x

[Run]
.step
    a = x
    b = x
    c = x

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 2.75
    @assert a == 2
    @assert b == 2
    @assert c == 2
    @stop
}
