spec 3.11  a != b != c is an error, and the message offers the likely meanings.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 c
F64 x

[Run]
.step
    x = a != b != c   #! E0331 and
