spec 5.32  A brace that is opened is closed.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    if true {   #! E0321
        x = 1
