spec 5.21  [all_states] belongs to scripts.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[all_states]   #! E0303
.step
    x = 1

[Run]
