spec 1.27  Two statements on one line without anything between them are an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[Run]
.step
    x = 1 y = 2   #! E0330
