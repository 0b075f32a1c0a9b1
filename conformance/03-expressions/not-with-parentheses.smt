spec 3.13  With parentheses around either reading there is no warning.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 x
F64 y
F64 z

[Run]
.step
    x = not (a == b)
    y = (not a) == b
    z = not a and b

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2
    b = 5
    @assert x == 1
    @assert y == 0
    @assert z == 0
    @stop
}
