spec 5.74  No edit excepts every state.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y
[all_states] @except Abort
.step
    x > 3: -> Abort
    x > 5: -> Run           #! E0505 write it in the states that it leaves
[Run]
.step
    y = x
[Abort]
