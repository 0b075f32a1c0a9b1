spec 5.36  A label ends its block, and no else reaches over it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.entry
    if T: x = 1
.step
    else: x = 2   #! E0318
