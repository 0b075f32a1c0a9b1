spec 5.27  x = y, y = x does not swap.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[Run]
.step
    x = y
    y = x

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 1
    y = 2
    @assert x == 2
    @assert y == 2
    @stop
}
