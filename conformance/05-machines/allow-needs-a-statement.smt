spec 5.50  In a block an @allow must be followed by a statement.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[A]
.entry
    @allow(dead-code, "x")                #! E0388
.step
    x > 1 {
        x = 1
        @allow(dead-code, "x")            #! E0388
    }
    x > 1: @allow(dead-code, "x")         #! E0388
    x > 2 {
        x = 5
    } @allow(dead-code, "x") x = 6
    @allow(dead-code, "x")                #! E0388
[B] @allow(dead-code, "x") x = 7          #! E0310
