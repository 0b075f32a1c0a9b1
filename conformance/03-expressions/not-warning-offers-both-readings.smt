spec 3.13  The warning shows both readings.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 x

[Run]
.step
    x = not a == b   #! W0401 not (a == b)
