spec 5.10   An initial value uses no windows.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 mean = roll_avg(x, 10)    #! E0409 which roll_avg cannot be
[Hold]
.step
    x = mean
