# An option that belongs to another command is refused.
args check --engine=ref a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: option '--engine' is not an option of 'smc check'
Try 'smc check --help'.
-- exit --
2
