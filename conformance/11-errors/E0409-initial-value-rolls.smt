spec 5.10   An initial value uses no windows.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 mean = roll_avg(x, 10)    #! E0409 the initial value of 'mean' must be a constant, which roll_avg is not
[Hold]
.step
    x = mean
