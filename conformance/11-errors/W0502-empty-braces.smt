spec 5.39   Empty braces are allowed, with a warning.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x > 800 { }               #! W0502
    x > 900 {                 #! W0502
        # nothing yet
    }
    else { }                  #! W0502
