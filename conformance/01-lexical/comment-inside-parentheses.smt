spec 1.8, 1.30  A comment within parentheses ends with its line, and the expression continues.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = (1 + # + 10 )
         2)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 3
    @stop
}
