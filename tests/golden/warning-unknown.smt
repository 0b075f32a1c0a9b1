# A warning that does not exist.
args check -Wunused-elephant a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
F64 spare
[Idle]
.step
    open = true
[Lost]
.step
    open = false
-- stderr --
smc: no warning is called 'unused-elephant'; did you mean 'unused-element'?
Try 'smc check --help'.
-- exit --
2
