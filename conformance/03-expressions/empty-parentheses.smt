spec 3.8  Parentheses contain a value.

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
    x = ()   #! E0312
