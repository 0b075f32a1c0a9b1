spec 5.26  A statement between the header of a state and its first label belongs to no block, which is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
    x = 1   #! E0310
.step
    x = 2
