spec 1.5  A control character within a comment is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1   # bell  #! E0101
