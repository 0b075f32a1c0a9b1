spec 5.28  Not an expression.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 a
F64 b

[Run]
.step
    x + 1 = 2   #! E0325
