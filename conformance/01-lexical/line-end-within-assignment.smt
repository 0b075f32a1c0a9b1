spec 1.27  An assignment cannot be continued on the next line before its operator: the line has ended the statement.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1
    + 2   #! E0327
