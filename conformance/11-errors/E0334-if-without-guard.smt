spec 5.30   if needs a condition.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    if: x = p           #! E0334 condition
    if { x = 1 }        #! E0334 condition
    if                  #! E0334 condition
    x = 2
