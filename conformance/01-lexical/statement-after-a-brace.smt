spec 1.28  After a closing brace the next statement may stand on the same line.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 z

[Run]
.step
    if true { x = 1 } y = 2
    if true {
        if true { x = 3 } z = 4 }

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 3
    @assert y == 2
    @assert z == 4
    @stop
}
