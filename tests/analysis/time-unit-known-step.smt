# Limits of T in seconds, where T counts milliseconds; with it, what is shorter, too.
warn time-unit no-dead-store no-constant-guard no-duplicate-guard no-shadowed-transition no-decided-comparison
advance 10
-- app.sm --
[state_vector]
U64 time @alias G
U32 S
F64 p @read_only
U8 x
[local]
F64 limit = 1.5 @read_only
[Hold]
.step
    T > 0.5: x = 1            #! W0420 'T' is compared with 0.5, and is a whole number
    2.5 <= T: x = 2           #! W0420 write 2.5 s if seconds are meant
    0.5 < T < 3.5: x = 3      #! W0420 0.5
    T > limit: x = 4          #! W0420 1.5
    p > 3 and T >= 1.5: x = 5 #! W0420 write 1.5 s
    T > 2: x = 6             #! W0420 advances by 10 in each step
    T > 0: x = 7
    T >= 1: x = 8
    T > 1500.5: x = 9
    T - 0.5 > p: x = 10
    p > 0.5: x = 11
    G > 0.5: x = 12
    T > 10 / 2: x = 13        #! W0420 5
