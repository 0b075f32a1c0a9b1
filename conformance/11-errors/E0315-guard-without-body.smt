spec 5.30, 5.32   A guard is followed by a colon or by braces.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    if p > 5 -> Hold        #! E0315 insert ':'
    p > 5 x = 1             #! E0315 insert ':'
    if p > 5                #! E0315 end of the line
    x = 1
