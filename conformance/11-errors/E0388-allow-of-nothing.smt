spec 5.50   An @allow precedes the source that it covers.

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
