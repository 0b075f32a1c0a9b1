spec 1.5  The delete character, 0x7F, is a control character.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1   #  #! E0101
