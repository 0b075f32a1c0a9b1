spec 5.5   An assignment has no colon; the edit removes it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x: = 1   #! E0341
