spec 5.34  else is executed when the guard is false, in each of its forms.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 x1
F64 x2
F64 x3
F64 x4
F64 x5
F64 x6

[Run]
.step
    if a: x1 = 1
    else: x1 = 2
    a { x2 = 1 }
    else { x2 = 2 }
    if a: x3 = 1
    else {
        x3 = 2
    }
    a {
        x4 = 1
    }
    else: x4 = 2
    if a { x5 = 1 } else { x5 = 2 }
    if a: x6 = 1 else: x6 = 2

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1
    @assert x1 == 1
    @assert x2 == 1
    @assert x3 == 1
    @assert x4 == 1
    @assert x5 == 1
    @assert x6 == 1
    @stop
}
