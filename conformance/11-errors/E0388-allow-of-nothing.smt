spec 5.50   An @allow stands before what it is about.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
[A]
.step
    a = 1
    @allow(dead-store, "x")
    @allow(dead-code, "x")                #! E0388
