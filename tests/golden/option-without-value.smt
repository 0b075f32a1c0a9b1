# An option at the end lacks its value.
args build a.sm --emit

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: option '--emit' requires a KIND after it
Try 'smc build --help'.
-- exit --
2
