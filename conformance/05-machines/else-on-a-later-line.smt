spec 5.36  Line ends and comments can precede else.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[Run]
.step
    if false: x = 1

    # otherwise

    else: x = 2
    if false { y = 1 }   # comment

    else { y = 2 }

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 2
    @assert y == 2
    @stop
}
