spec 5.7  Neither by its alias.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only @alias p
F64 y

[Run]
.step
    p = 5   #! E0212
