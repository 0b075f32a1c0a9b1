spec 5.2  A listed element that the vector does not have is an error.

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
F64 pressure   #! E0205

[Run]
.step
    pressure = 1
