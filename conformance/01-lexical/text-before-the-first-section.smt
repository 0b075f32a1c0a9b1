spec 1.34  What stands before the first section header belongs to nothing.

-- app.sm --
F64 x   #! E0301
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1
