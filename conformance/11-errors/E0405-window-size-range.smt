spec 7.2   The size of a window is 1 to 100000.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
U16 n = 70000
[Hold]
.step
    x = roll_avg(x, 0)        #! E0405 must be 1 to 100000, not 0
    x = roll_avg(x, -3)       #! E0405 not -3
    x = roll_avg(x, 100001)   #! E0405 not 100001
    x = roll_avg(x, 1e300)    #! E0405 not 1e+300
    x = roll_avg(x, 1 / 0)    #! E0405 not inf
    x = roll_avg(x, 100000) + roll_avg(x, 1) + roll_avg(x, n)
