spec 5.5  mode is kept by others than the machine.

-- app.sm --
[state_vector]
U64 time @alias G
U32 mode @alias S

[Run]
.step
    mode = 5   #! E0215
