spec 5.9   A local has an initial value.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[local]
F64 a           #! E0355 a = 0
F64
    b
    =
    2
[Hold]
.step
    x = a + b + p
