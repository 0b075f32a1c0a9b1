spec 1.38  A unit directly after the number is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1.5s    #! E0114 did you mean '1.5 s'?
