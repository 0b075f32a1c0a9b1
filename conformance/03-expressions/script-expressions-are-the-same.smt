spec 3.9, 3.15, 3.23  An expression in a script means what it means in a machine.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 z

[Run]
.step
    x = 2.5

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = -0.0
    @assert 1 < x <= 2.5 < 3
    @assert 1 / -z == 1/0
    @assert round(x) == 3
    @assert min(x, 1) + clamp(x, 0, 2) == 3
    @assert x == 1 + 1.5 and not (x == 2)
    @stop
}
