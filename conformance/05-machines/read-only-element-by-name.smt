spec 5.7  Nor by its name, where it has an alias.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @alias p @read_only
F64 y

[Run]
.step
    x = 5   #! E0212
