spec 5.1  A listed element has no initial value.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x = 5   #! E0356

[Run]
.step
    x = 1
