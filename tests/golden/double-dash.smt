# Behind -- everything is a file.
args check -- -odd.sm

-- -odd.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
