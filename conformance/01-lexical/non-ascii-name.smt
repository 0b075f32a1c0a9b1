spec 1.1  A letter outside ASCII cannot be part of a name.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 größe = 1   #! E0102

[Run]
.step
    x = 1
