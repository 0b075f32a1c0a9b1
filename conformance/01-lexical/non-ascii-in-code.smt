spec 1.1  A typographic minus is no ASCII character and an error outside comments.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 5 – 3   #! E0102
