# What is right is said by silence.
args check a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
