spec 5.30  A statement after a guard is executed when the guard is true, with or without if.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 x
F64 y
F64 z
F64 w

[Run]
.step
    a > 5: x = 1
    if a > 5: y = 1
    a > 50: z = 1
    if a > 50: w = 1

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 6
    @assert x == 1
    @assert y == 1
    @assert z == 0
    @assert w == 0
    @stop
}
