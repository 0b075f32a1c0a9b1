spec 1.36  A word before '(' is a function, not a unit.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 5 min (3, 4)    #! E0330
