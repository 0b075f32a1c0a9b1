spec 1.25   A label has no colon.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step:          #! E0311 '.step'
    x = p
