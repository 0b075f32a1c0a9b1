spec 5.40  Braces need a guard.

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
    {   #! E0320
        x = 1
    }
