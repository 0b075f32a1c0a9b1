spec 5.2  A listed element must have the type it has in the vector.

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
F32 p   #! E0206

[Run]
.step
    p = 1
