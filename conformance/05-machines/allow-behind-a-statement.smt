spec 5.50  An @allow precedes its statement; after the statement it is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[A]
.step
    x = 2 @allow(dead-code, "x")          #! E0330 write it before the statement
