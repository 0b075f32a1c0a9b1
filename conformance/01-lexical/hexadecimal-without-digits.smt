spec 1.13, 1.16  0x without a digit is no number.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 0x   #! E0113
