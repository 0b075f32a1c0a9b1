spec 5.8  What is stored under one name is read under the other, in the same step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure @alias p
F64 x
F64 y

[Run]
.step
    p = 5
    x = pressure
    pressure = pressure + 1
    y = p

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    p = 1
    @assert x == 5
    @assert y == 6
    @assert p == 6 and pressure == 6
    @stop
}
