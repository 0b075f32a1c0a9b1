spec 3.17   A wrong number of values is an error.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x = clamp(x, 10)          #! E0401 clamp takes 3 arguments, not 2
    x = roll_avg(x)           #! E0401 roll_avg(x, n)
    x = abs(1, 2)             #! E0401 abs takes 1 argument, not 2
    x = min()                 #! E0401 not 0
    x = max(y)                #! E0401 max #! E0204 'y'
