spec 3.12, 3.13  not a == b means (not a) == b: for a = 2, b = 5 it is false, though a == b is false.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 x

[Run]
.step
    x = not a == b   #! W0401

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2
    b = 5
    @assert x == 0
    @stop
}
