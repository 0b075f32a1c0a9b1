spec 7.27  They are windows: not in initial values and sizes.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
[local]
F64 n = prev(3)              #! E0409
[Run]
.step
    a = roll_avg(p, prev(2)) #! E0403
    a = prev(p, 2)           #! E0401 prev takes 1 argument, not 2
    a = rising()             #! E0401
    a = prev + n             #! E0219
