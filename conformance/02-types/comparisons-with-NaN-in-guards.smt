spec 2.11  A guard that compares with NaN is false, and its negation is true: not (a < b) is not a >= b.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 z
F64 x
F64 y
F64 w

[Run]
.step
    if z / z < a: x = 1
    else: x = 2
    if z / z >= a: y = 1
    else: y = 2
    if not (z / z < a): w = 1
    else: w = 2

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1
    z = 0
    @assert x == 2
    @assert y == 2
    @assert w == 1
    @stop
}
