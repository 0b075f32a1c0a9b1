spec 5.9  A local needs an initial value.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 a   #! E0355
F64 b = 1

[Run]
.step
    x = b
