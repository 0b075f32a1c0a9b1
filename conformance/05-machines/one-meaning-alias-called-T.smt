spec 5.15  A name has one meaning; the error is at the second declaration.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @alias T   #! E0203

[Run]
.step
    G == 5: -> Run
