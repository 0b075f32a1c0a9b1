spec 1.2  A comment is UTF-8: a stray byte 0xFF is none.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1   # ÿ #! E0103
