spec 1.10  Names consist of letters, digits and _, and may begin with _.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 _
F64 _1
F64 a1_b2
F64 __x__
F64 Z9

[Run]
.step
    _ = 1
    _1 = 2
    a1_b2 = 3
    __x__ = 4
    Z9 = 5

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert _ == 1
    @assert _1 == 2
    @assert a1_b2 == 3
    @assert __x__ == 4
    @assert Z9 == 5
    @stop
}
