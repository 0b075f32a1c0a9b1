spec 1.26   An annotation that does not exist is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[local]
F64 a = 1 @readonly     #! E0360 did you mean '@read_only'?
[Hold]
.step
    x = a + p
