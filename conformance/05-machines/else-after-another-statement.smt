spec 5.36  A statement between a conditional and else separates them.

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
    y = 2
    else: x = 2   #! E0318
