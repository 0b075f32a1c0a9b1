spec 5.38   A line end directly after the colon of a guard or of else is an error, comment or not.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    if p > 5:           #! E0316 the condition
        x = 1
    x > 5:  # comment       #! E0316 x > 5 { ... }
        x = 2
    p > 7: x = 3
    else:               #! E0316 else { ... }
        x = 4
