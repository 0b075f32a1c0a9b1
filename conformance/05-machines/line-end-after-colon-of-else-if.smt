spec 5.38  And after that of else if.

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
    else if b:   #! E0316 {
        x = 2
