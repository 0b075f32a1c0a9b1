spec 5.74  The target of a transition must be excepted.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[all_states]
.step
    x > 3: -> Abort                #! E0505 write @except Abort
[all_states] @except Safe
.step
    x > 4 {
        x < 9: -> Abort            #! E0505 write @except Safe Abort
        -> Safe
    } else: -> Abort               #! E0505
[Run]
[Abort]
[Safe]
