spec 5.7  A read-only element cannot be assigned.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y

[Run]
.step
    x = 5   #! E0212
