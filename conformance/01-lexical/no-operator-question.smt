spec 1.21  What other languages write is an error here: x ?.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = x ?   #! E0108
