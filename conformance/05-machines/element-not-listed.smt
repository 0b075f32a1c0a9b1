spec 5.2, 5.20  An element of the vector that the machine does not list cannot be used.

-- app.sv --
[R]
U64 G
U32 S
F64 p
U8 n

-- app.sm --
[state_vector]
U64 G
U32 S
U8 n

[Run]
.step
    n = p   #! E0204
