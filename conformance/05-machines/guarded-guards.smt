spec 5.31  A conditional can follow the colon: both guards must be true.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x0
F64 x1
F64 x2
F64 x3
F64 x4
F64 x5

[Run]
.step
    true: true: x1 = 1
    true: if false: x2 = 1
    if false: if true: x3 = 1
    if true: if true: true: x4 = 1
    true: if true { x5 = 1 }

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x1 == 1
    @assert x2 == 0
    @assert x3 == 0
    @assert x4 == 1
    @assert x5 == 1
    @stop
}
