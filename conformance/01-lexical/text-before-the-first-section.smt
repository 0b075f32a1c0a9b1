spec 1.34  Text before the first section header is an error.

-- app.sm --
F64 x   #! E0301
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1
