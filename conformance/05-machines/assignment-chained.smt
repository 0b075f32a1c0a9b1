spec 5.28  An assignment is no value.

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
    x = y = 2   #! E0330
