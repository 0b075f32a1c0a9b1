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
smc: a.smb: refused by rule 4 at byte 4: its CRC-32 is right
-- exit --
0 1
