spec 3.13  !a != b is warned about just the same.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 x

[Run]
.step
    x = !a != b   #! W0401

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 2
    b = 5
    @assert x == 1
    @stop
}
