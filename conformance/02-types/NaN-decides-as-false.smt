spec 2.14  A guard that is NaN is false.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 z
F64 x

[Run]
.step
    if z / z: x = 1
    else: x = 2
    z / z { x = x + 10 }

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    @assert x == 2
    @stop
}
