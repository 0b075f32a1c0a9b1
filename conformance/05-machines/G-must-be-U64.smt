spec 5.3  G of another type is an error.

-- app.sm --
[state_vector]
U32 G   #! E0210
U32 S
F64 x

[Run]
.step
    x = 1
