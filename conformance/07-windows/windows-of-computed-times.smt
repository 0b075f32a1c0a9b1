spec 7.26  A number computed from a time is no size.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
[options]
step 20 ms
[define]
twice = 20 ms + 20 ms
[local]
F64 n = 60 ms @read_only
F64 m = n / 20 @read_only
[Run]
.step
    a = roll_avg(p, twice)           #! E0413
    a = roll_avg(p, n)               #! E0413 make 'n' a definition
    a = roll_avg(p, m)               #! E0413
    a = roll_avg(p, 20 ms + 1)       #! E0413
    a = roll_avg(p, n steps)         #! E0413
    a = roll_avg(p, -20 ms)          #! E0413
