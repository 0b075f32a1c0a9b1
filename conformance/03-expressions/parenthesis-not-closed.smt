spec 3.8  A parenthesis that is opened is closed.

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
    x = (a + b   #! E0313
