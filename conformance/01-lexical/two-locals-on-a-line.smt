spec 1.33  The initial value ends at the line end: a second local behind it on the same line is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 a = 1 F64 b = 2   #! E0330

[Run]
.step
    x = a
