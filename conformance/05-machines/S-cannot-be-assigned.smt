spec 5.5  S is kept by others than the machine.

-- app.sm --
[state_vector]
U64 time @alias G
U32 mode @alias S

[Run]
.step
    S = 5   #! E0215
