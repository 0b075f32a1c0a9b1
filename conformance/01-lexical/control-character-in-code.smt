spec 1.5  A control character outside comments is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1   #! E0101
