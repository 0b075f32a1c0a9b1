# What is no image is refused with the reason.
args disasm a.sm
args verify a.sm
args verify nowhere.smb

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: a.sm: refused by rule 1 at byte 0: an image begins with the bytes 's' 'm' 'b'
smc: a.sm: refused by rule 1 at byte 0: an image begins with the bytes 's' 'm' 'b'
smc: cannot read 'nowhere.smb': No such file or directory
-- exit --
1 1 3
