spec 2.13  Inside an expression nothing is converted: 200 + 100 - 60 fits a U8 at the end, and 0.6 + 0.6 is rounded down once.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 a
U8 b
U8 x
U8 y
bool p
F64 z

[Run]
.step
    x = a + b - 60
    y = 0.6 + 0.6
    p = 0.5 - 0.25
    z = (a + b) / 7

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 200
    b = 100
    @assert x == 240
    @assert y == 1
    @assert p
    @assert z == 42.857142857142854
    @stop
}
