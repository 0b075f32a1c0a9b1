# Numbers that the type of the variable cannot hold.
warn float-equality no-constant-guard no-dead-store
-- app.sm --
[state_vector]
U64 G
U32 S
F32 x @read_only
F64 d @read_only
U8 n @read_only
F32 y
[local]
F64 tenth = 0.1 @read_only
F32 short = 0.1 @read_only
[Hold]
.step
    x == 0.1: -> Hold         #! W0413 this is never true: 'x' is F32 and is never exactly 0.1
    x != 0.1: y = 1           #! W0413 this is always true: 'x' is F32 and is never exactly 0.1
    0.3 == x: -> Hold         #! W0413 the nearest F32 is 0.3
    x == tenth: -> Hold       #! W0413
    n == 2.5: -> Hold         #! W0414 whole number and is never 2.5
    n != 0.5: y = 2           #! W0414
    T == 2.5: -> Hold         #! W0414
    roll_min(x, 3) == 0.1: -> Hold    #! W0413 'roll_min(x, 3)'
    x == short: -> Hold
    x == 0.5: -> Hold
    x > 0.1: -> Hold
    d == 0.1: -> Hold
    x == d: -> Hold
    n == 2: -> Hold
    n > 2.5: -> Hold
    roll_avg(x, 3) == 0.1: -> Hold
