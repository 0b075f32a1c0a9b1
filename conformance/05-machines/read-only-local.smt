spec 5.13  A read-only local cannot be assigned.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 a
F64 b

[local]
F64 k = 1 @read_only

[Run]
.step
    k = 2   #! E0213
    x = k
