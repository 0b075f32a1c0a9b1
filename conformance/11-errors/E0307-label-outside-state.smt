spec 5.25   A label belongs to a state.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[local]
F64 a = 1
.step           #! E0307 '.step'
[Hold]
.step
    x = a
