spec 5.29  A transition names its state; a number is an error.

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
    -> 2   #! E0323
