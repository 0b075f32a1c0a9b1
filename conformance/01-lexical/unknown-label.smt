spec 1.25  There is no label but .entry, .step and .exit.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.enter   #! E0308
    x = 1
