spec 5.29  An element is no state.

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
    -> x   #! E0501
