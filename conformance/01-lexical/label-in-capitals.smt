spec 1.25  A label is written in small letters.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.Step   #! E0308
    x = 1
