spec 2.11, 3.14  A negated comparison with NaN is true, as a value or as a part of a guard.

-- app.sm --
[state_vector]
U64  G
U32  S
F64  a
F64  z
bool x
bool y
F64  w

[Run]
.step
    x = not (z / z < a)
    y = not (z / z >= a)
    if not (z / z < a) and a > 0: w = 1
    else: w = 2

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 1
    z = 0
    @assert x
    @assert y
    @assert w == 1
    @stop
}
