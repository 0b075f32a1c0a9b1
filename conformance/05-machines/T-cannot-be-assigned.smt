spec 5.6  T is kept by others than the machine.

-- app.sm --
[state_vector]
U64 time @alias G
U32 mode @alias S

[Run]
.step
    T = 5   #! E0216
