spec 7.24  The time is a multiple of the step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
[options]
step 20 ms
[Run]
.step
    a = roll_avg(p, 50 ms)        #! E0412 40 ms or 60 ms
    a = roll_avg(p, 1 us)         #! E0412 0 ms or 20 ms
    a = roll_avg(p, 2000 s)       #! E0405 not 100001
    a = roll_avg(p, 1e10 h)       #! E0405
    a = roll_avg(p, 1999.98 s)
