spec 7.2   The size of a window is a whole number.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F32 n = 0.1
[Hold]
.step
    x = roll_avg(x, 5 / 2)    #! E0404 not 2.5
    x = roll_avg(x, n)        #! E0404 not 0.100000001
    x = roll_avg(x, 0 / 0)    #! E0404 not NaN
