spec 5.73  An else belongs to no conditional of [all_states].

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[all_states]
.step
    x > 3: x = 1
[Run]
.step
    else: x = 2                    #! E0318
