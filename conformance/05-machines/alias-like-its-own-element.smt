spec 5.16  An alias equal to the name of its element is useless, and warned about.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @alias x   #! W0201
F64 y

[Run]
.step
    y = x

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 3
    @assert y == 3
    @stop
}
