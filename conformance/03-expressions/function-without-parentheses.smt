spec 3.18, 5.20  Without parentheses abs is a name like any other, and here it is not declared.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 c
F64 x

[Run]
.step
    x = abs   #! E0219
