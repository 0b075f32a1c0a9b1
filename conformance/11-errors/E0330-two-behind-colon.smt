spec 5.4   One statement follows a colon; an assignment before a colon was meant to compare if no guard precedes it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
bool on
[Hold]
.step
    if p > 5: on = true: x = 1   #! E0330 braces
    x = 5: on = true             #! E0324
