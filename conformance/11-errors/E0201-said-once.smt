spec 5.15   A name that is declared twice causes no further error.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
[local]
F64 x = 1        #! E0201
F64 y = x
[Hold]
.step
    x = roll_avg(y, x)
