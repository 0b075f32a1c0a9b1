spec 2.6  -0 less 0 is -0, plus 0 it is 0.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 less
F64 plus

[Run]
.step
    less = x - 0
    plus = x + 0

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = -0.0
    @assert 1 / less < 0
    @assert 1 / plus > 0
    @stop
}
