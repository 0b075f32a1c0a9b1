spec 5.15  A name has one meaning; the error is at the second declaration.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
U64 T = 1   #! E0203

[Run]
.step
    G == 5: -> Run
