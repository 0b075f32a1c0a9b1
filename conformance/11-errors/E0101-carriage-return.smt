spec 1.4, 1.5   A carriage return in the middle of a line is an error; before the line end it is a space.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = 1
    x = 2  x = 3     #! E0101 0x0D #! E0330 end of the line
