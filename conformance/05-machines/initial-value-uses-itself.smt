spec 5.10  An initial value cannot use this: k.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 k = 1 + k   #! E0407
F64 z = 2

[Run]
.step
    x = k
