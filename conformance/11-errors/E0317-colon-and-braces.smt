spec 5.30   Either a colon or braces follow a guard.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    p > 5: {            #! E0317 not both
        x = 1
    }
    else: { x = 2 }     #! E0317 not both
