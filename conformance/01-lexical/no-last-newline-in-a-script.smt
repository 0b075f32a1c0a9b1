spec 1.6  A script may end right after the brace of its last conditional.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 1
    @stop
}