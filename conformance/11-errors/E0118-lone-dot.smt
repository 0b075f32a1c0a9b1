spec 1.25   A label follows its point directly.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = 1
    . exit        #! E0118 .exit
