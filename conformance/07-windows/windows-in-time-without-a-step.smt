spec 7.24  A window in time needs the step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
[Run]
.step
    a = roll_avg(p, 40 ms)        #! E0411 roll_avg
