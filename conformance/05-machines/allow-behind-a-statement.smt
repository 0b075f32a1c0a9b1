spec 5.50  An @allow stands before its statement, not behind it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[A]
.step
    x = 2 @allow(dead-code, "x")          #! E0330 write it before the statement
