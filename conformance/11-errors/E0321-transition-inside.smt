spec 5.32   What stands behind a transition is not known where a brace is missing.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
[Hold]
.step
    if p > 3 {            #! E0321 this '{' has no matching '}'
        p = 1
        -> Idle
    p > 5: p = 0
[Idle]
.step
    p > 5: p = 0
