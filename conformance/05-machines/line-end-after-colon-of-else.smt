spec 5.38  The same after the colon of else.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 a
F64 b

[Run]
.step
    if a: x = 1
    else:   #! E0316 {
        x = 2
