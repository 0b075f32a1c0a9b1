# Statements of [all_states] after a transition of another section: useless only if they run in no state.
warn extra no-missing-way-out no-unused-element no-all-states-skipped

-- app.sm --
[state_vector]
U64 G
U32 S
F64 y
F64 z

[Run]
[all_states] @except Done
.step
    -> Done
[all_states]
.step
    y = 3
[all_states] @except Done
.step
    z = 3                   #! W0501 the transition before it ends the block
[Done]
