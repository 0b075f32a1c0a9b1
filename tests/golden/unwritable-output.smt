# An output that cannot be written is the environment's fault.
args build a.sm -o nowhere/a.smb

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: cannot write 'nowhere/a.smb': No such file or directory
-- exit --
3
