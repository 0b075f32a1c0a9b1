spec 2.15, 3.15  A variable of a whole-number type reads as 0 and never −0, also just after a −0 was stored there.

-- app.sm --
[state_vector]
U64 G
U32 S
I32 x
I16 y
F64 of_negated
F64 of_product
F32 of_rest

[local]
I32 negated = 2
I32 product = 2
I16 rest = 2

[Run]
.step
    negated = -(0 == 1 - x)
    of_negated = negated
    product = x * y
    of_product = product
    rest = -y
    of_rest = rest

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: x = 0
G == 0: y = -3
G == 1: x = 1
G == 1: y = 0

[Run]
G == 0 {
    @assert 1 / of_negated > 0
    @assert 1 / of_product > 0
    @assert of_rest == 3
}
G == 1 {
    @assert of_negated == -1
    @assert 1 / of_product > 0
    @assert 1 / of_rest > 0
}
G == 2: @stop
