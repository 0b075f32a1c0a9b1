spec 2.13  A guard of 0.25 is true: it is not truncated to a whole number first.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 x
F64 y

[Run]
.step
    if a: x = 1
    if a - 0.25: y = 1
    else: y = 2

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0.25
    @assert x == 1
    @assert y == 2
    @assert 0.25
    @stop
}
