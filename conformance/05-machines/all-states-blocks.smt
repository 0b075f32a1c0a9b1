spec 5.68  Such a section has the block .step only.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[all_states]
.entry                             #! E0394 in .entry of each state that needs them
    x = 1
.step
    x = 2
.exit                              #! E0394 in .exit of each state that needs them
    x = 3
[all_states]
x = 4                              #! E0310
[all_states]
[Run]
