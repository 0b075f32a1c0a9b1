spec 5.27  Each statement sees the effects of those above it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[Run]
.step
    x = 1
    y = x
    x = x + 1
    y = y * 10 + x
    x = x * 3

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 6
    @assert y == 12
    @stop
}
