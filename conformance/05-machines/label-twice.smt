spec 5.25  A block appears once in its state.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1
.step   #! E0309
    x = 2
