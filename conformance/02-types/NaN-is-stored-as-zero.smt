spec 2.14  NaN becomes 0 in every type.

-- app.sm --
[state_vector]
U64 G
U32 S
I8 x0
I16 x1
I32 x2
I64 x3
U8 x4
U16 x5
U32 x6
U64 x7
F32 x8
F64 x9
bool x10
F64 z

[Run]
.step
    x0 = z / z
    x1 = z / z
    x2 = z / z
    x3 = z / z
    x4 = z / z
    x5 = z / z
    x6 = z / z
    x7 = z / z
    x8 = z / z
    x9 = z / z
    x10 = z / z

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    z = 0
    x0 = 5
    x1 = 5
    x2 = 5
    x3 = 5
    x4 = 5
    x5 = 5
    x6 = 5
    x7 = 5
    x8 = 5
    x9 = 5
    x10 = 5
    @assert x0 == 0
    @assert x1 == 0
    @assert x2 == 0
    @assert x3 == 0
    @assert x4 == 0
    @assert x5 == 0
    @assert x6 == 0
    @assert x7 == 0
    @assert 1 / x8 == 1/0
    @assert 1 / x9 == 1/0
    @assert x10 == 0
    @stop
}

-- trace --
1 x0 0
1 x1 0
1 x10 false
1 x2 0
1 x3 0
1 x4 0
1 x5 0
1 x6 0
1 x7 0
1 x8 0x0p+0
1 x9 0x0p+0
