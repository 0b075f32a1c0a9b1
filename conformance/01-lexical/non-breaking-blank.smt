spec 1.1  A non-breaking blank is no blank.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 5   #! E0102
