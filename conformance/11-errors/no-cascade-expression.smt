spec 5.20   One mistake causes one message: the surrounding expression causes no further one.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 a = b * 2                 #! E0204 'b'
F64 c = a + 1
[Hold]
.step
    x = roll_avg(roll_max(a, c), c) + clamp(q, a, c)     #! E0204 'q'
    -> Abbort                 #! E0501
    .exit
    x = abs(q)
