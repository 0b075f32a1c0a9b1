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
smc: a.sm: refused, because rule 1 is violated at byte 0: an image begins with the bytes 's' 'm' 'b'
smc: it is no image; 'smc build' makes one of a machine
smc: a.sm: refused, because rule 1 is violated at byte 0: an image begins with the bytes 's' 'm' 'b'
smc: it is no image; 'smc build' makes one of a machine
smc: cannot read 'nowhere.smb': No such file or directory
-- exit --
1 1 3
