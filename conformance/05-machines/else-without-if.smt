spec 5.36  An else without a conditional is an error.

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
    else: x = 2   #! E0318
