# A machine without a script.
args test a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: no script is named to test 'a.sm' with, as in 'smc test a.sm SCRIPT.ss'
Try 'smc test --help'.
-- exit --
2
