spec 5.21   [options] and [all_states] are errors in a machine.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[options]       #! E0303 [options]
lock
[all_states]    #! E0303 [all_states]
x = 1
[Hold]
.step
    x = p
