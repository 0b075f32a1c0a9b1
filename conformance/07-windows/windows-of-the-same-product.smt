spec 7.8  Samples of two windows that are made of the same product.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
F64 a
F64 b

[Run]
.step
    a = roll_avg(p * 2.5, 3)
    b = roll_max(p * 2.5 * 2.5 * 2.5, 3)

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    p = 2
    q = 4
    @assert a == 5
    @assert b == 31.25
    @stop
}
