spec 5.40  An assignment is no guard.

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
    x = 1
    {   #! E0320
        y = 1
    }
