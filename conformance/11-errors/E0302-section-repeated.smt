spec 5.1, 5.9   [state_vector] and [local] stand once.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[local]
F64 a = 1
[local]       #! E0302 [local]
F64 b = 2
[Hold]
.step
    x = a + b
