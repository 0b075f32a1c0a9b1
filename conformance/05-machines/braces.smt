spec 5.32  Braces contain any number of statements and conditionals, on several lines or on one.

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
    a > 5 {
        x = 1
        y = 2
        if a > 6 {
            z = 3
            a > 7 { z = 4 }
        }
        x = x + 1
        y = y + 1
    }
    if a > 9 {
        x = 5
        y = 6
    }
    if a { w = 1 }

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 7
    @assert x == 2
    @assert y == 3
    @assert z == 3
    @assert w == 1
    @stop
}
