spec 5.26  The same where the state has no label at all.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
    x = 1   #! E0310
