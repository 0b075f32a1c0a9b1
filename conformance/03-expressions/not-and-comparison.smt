spec 3.12, 3.13  not a < b means (not a) < b, with a warning: for a = 7, b = 1 it is 0 < 1.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 x

[Run]
.step
    x = not a < b   #! W0401

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 7
    b = 1
    @assert x == 1
    @stop
}
