spec 5.36  A conditional has one else.

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
    else: x = 2
    else: x = 3   #! E0318
