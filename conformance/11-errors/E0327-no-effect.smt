spec 5.28   A value alone is no statement.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x == 1              #! E0327 x = 1
    x + 1               #! E0327 this value has no effect
    p                   #! E0327 this value has no effect
    abs(p)              #! E0327 this value has no effect
    print(p)            #! E0217 'print'
    p > 1: halt         #! E0204 'halt'
    p > 1: halt         #! E0327 this value has no effect
