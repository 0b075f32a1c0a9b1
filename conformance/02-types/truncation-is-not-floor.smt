spec 2.15  Negative values lose their fraction toward zero.

-- app.sm --
[state_vector]
U64 G
U32 S
I8 a
I64 b
I16 c
F64 x

[Run]
.step
    a = -x
    b = -x - 1
    c = -x * 0.5

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 2.75
    @assert a == -2
    @assert b == -3
    @assert c == -1
    @stop
}
