spec 3.17  A call of something unknown or with the wrong number of values is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 c
F64 x

[Run]
.step
    x = roll_avg(a)   #! E0401
