spec 3.11  a and b + 1 == b == c or a is an error, and the message offers the likely meanings.

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
    x = a and b + 1 == b == c or a   #! E0331 and
