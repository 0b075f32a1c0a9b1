spec 1.14  An underscore that does not stand between two digits is an error: 1_.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1_   #! E0111
