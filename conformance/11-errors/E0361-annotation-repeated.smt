spec 1.26   An annotation appears once on one declaration.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[local]
F64 a = 1 @read_only @read_only     #! E0361 '@read_only'
[Hold]
.step
    x = a + p
