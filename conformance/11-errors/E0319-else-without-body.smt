spec 5.34   An else is followed by a colon, braces or if.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    p > 5: x = 1
    else x = 2          #! E0319 insert ':'
    p > 5: x = 1
    else                #! E0319 the end of the line
    x = 3
