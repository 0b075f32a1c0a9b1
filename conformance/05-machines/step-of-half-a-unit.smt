spec 5.58  A step is a whole number of units from 1 to 2^63.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[options]
step 0.5 ms           #! E0702 step must be a whole number

[Run]
.step
    x = 1
