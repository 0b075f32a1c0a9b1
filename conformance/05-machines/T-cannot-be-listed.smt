spec 5.6, 5.15  An element cannot be called T in a machine.

-- app.sm --
[state_vector]
U64 G
U32 S
U64 T   #! E0203
F64 x

[Run]
.step
    x = 1
