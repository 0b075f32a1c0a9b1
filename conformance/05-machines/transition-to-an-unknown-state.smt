spec 5.29  A state that does not exist is an error.

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
    -> Abrot   #! E0501
