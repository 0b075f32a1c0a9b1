spec 1.30   A parenthesis that is not closed ends where the next statement begins.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = (p + 1          #! E0313 end of the line
    x = 2
    x = (p +
    x = 2               #! E0313 found '='
    x = 3
