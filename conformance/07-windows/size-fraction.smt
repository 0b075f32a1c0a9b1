spec 7.2  The size is a whole number from 1 to 100000, so 2.5 is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p

[Run]
.step
    x = roll_avg(p, 2.5)   #! E0404
