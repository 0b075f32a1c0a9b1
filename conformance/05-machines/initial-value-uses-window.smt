spec 5.10  An initial value cannot use this: roll_avg(1, 2).

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 k = 1 + roll_avg(1, 2)   #! E0409
F64 z = 2

[Run]
.step
    x = k
