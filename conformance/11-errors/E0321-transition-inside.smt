spec 5.32   Where a brace is missing, statements after a transition are not reported.

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
