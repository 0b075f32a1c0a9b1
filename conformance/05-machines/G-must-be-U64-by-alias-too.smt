spec 5.3  The same for an element that is G by its alias.

-- app.sm --
[state_vector]
I64 time @alias G   #! E0210
U32 S
F64 x

[Run]
.step
    x = 1
