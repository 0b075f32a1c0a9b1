spec 1.31  Outside parentheses a line end after an operator is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x =   #! E0312
    x < 2: x = 3
