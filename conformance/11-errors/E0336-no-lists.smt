spec 1.23   There are no lists of values.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p[3]            #! E0336 'p[3]'
    x = p
