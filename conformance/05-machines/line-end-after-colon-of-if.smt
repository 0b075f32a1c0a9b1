spec 5.38  A line end after the colon is an error: the statement below would not depend on the guard.

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
    if a > 5:   #! E0316 {
        x = 1
