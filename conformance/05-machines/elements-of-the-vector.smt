spec 5.2  A machine lists the elements of the state vector it uses, in any order.

-- app.sv --
[R]
U64 G
U32 S
F64 p
U8 n

-- app.sm --
[state_vector]
U64 G
U32 S
U8 n
F64 p

[Run]
.step
    n = p * 2

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    p = 4
    @assert n == 8
    @stop
}
