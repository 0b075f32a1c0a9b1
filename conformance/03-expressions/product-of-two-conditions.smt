spec 3.14  A product used by two conditions of a guard is computed for the second, whatever the result of the first.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 z

[Run]
.step
    (x * y > 3 and z / y > 2) or x * y < -5 : -> Out

[Out]
.step
    not (x * y > -5 and (x * y < 3 or z / y < 2)) : -> Run

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    x = 2
    y = 1
    z = 1
}
G == 1 {
    @assert S == 1
    y = -3
}
G == 2 {
    @assert S == 2
    y = 1
    z = 1
}
G == 3 {
    @assert S == 2
    y = 2
    z = 1
}
G == 4 {
    @assert S == 2
    z = 5
}
G == 5 {
    @assert S == 1
    @stop
}
