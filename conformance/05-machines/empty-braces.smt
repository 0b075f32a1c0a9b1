spec 5.39  Empty braces do nothing, and are warned about.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 x

[Run]
.step
    if a { }   #! W0502
    else: x = 1
    a {   #! W0502
    }
    x = x + 1

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1
    @assert x == 1
    @stop
}
