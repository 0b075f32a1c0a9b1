spec 5.28, 5.30  A value by itself does nothing and is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 a
F64 b

[Run]
.step
    x + 1   #! E0327
    -> Run
