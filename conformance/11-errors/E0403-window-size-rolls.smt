spec 7.1   The size of a window cannot come from a window.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x = roll_avg(x, roll_max(x, 5))    #! E0403 which roll_max is not
