spec 1.26  An annotation that does not exist is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @readonly   #! E0360

[Run]
.step
    x = 1
