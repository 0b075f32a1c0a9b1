spec 5.1   An element has no initial value.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 y = 3       #! E0356 'y'
[Hold]
.step
    x = p
