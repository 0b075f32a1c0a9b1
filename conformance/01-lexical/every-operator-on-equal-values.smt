spec 1.21  The same with equal values: < and <= differ, > and >= too.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x1
F64 x2
F64 x3
F64 x4
F64 x5
F64 x6
F64 x7
F64 x8
F64 x9
F64 x10
F64 x11
F64 x12
F64 a
F64 b

[Run]
.step
    x1 = a + b
    x2 = a - b
    x3 = a * b
    x4 = a / b
    x5 = a < b
    x6 = a <= b
    x7 = a > b
    x8 = a >= b
    x9 = a == b
    x10 = a != b
    x11 = a and b
    x12 = a or b

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 3
    b = 3
    @assert x1 == 6
    @assert x2 == 0
    @assert x3 == 9
    @assert x4 == 1
    @assert x5 == 0
    @assert x6 == 1
    @assert x7 == 0
    @assert x8 == 1
    @assert x9 == 1
    @assert x10 == 0
    @assert x11 == 1
    @assert x12 == 1
    @stop
}
