spec 1.32, 5.1   An annotation belongs to the name before it, on any line.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
@read_only F64 y    #! W0301 'p' above
F64 z
@read_only
@alias zz
[Hold]
.step
    x = y + p
