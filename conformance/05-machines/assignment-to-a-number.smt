spec 5.28  Only an element or a local can be assigned.

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
    5 = x   #! E0325
