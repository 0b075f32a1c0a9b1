spec 5.40   Braces without a guard or else before them are an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    {                   #! E0320 expected a condition before these braces
        x = p
    }
