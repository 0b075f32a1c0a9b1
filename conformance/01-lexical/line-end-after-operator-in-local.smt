spec 1.31  In an initial value too.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 k = 1 +   #! E0312
F64 l = 2

[Run]
.step
    x = 1
