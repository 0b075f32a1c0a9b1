spec 5.9  A local needs a name.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 = 1   #! E0353

[Run]
.step
    x = 1
