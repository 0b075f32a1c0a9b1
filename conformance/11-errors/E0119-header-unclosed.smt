spec 1.23   A section header is closed on its line.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold           #! E0119 write [Hold]
.step
    x = p
