spec 1.33  An initial value cannot be continued on the next line outside parentheses.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 a = 1
    + 2   #! E0350

[Run]
.step
    x = a
