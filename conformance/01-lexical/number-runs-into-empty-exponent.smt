spec 1.16  A number directly followed by what cannot belong to it is an error: 1e.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1e   #! E0113
