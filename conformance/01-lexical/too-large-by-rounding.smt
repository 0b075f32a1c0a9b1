spec 1.18  A number beyond the largest F64 is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1.797693134862315808e308   #! E0112
