spec 5.9  [local] appears at most once.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 a = 1

[local]   #! E0302
F64 b = 2

[Run]
.step
    x = a
