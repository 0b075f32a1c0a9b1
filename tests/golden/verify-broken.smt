# A byte that changed is found.
args build a.sm && printf x | dd of=a.smb bs=1 seek=60 conv=notrunc 2>/dev/null
args verify a.smb

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: a.smb: refused, because rule 4 is violated at byte 4: its CRC-32 is correct
smc: it is damaged, or not all of it is there: copy it again, or build it again from its sources
-- exit --
0 1
