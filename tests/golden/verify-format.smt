# An image of an older format must be built again.
args build a.sm && printf '\001' | dd of=a.smb bs=1 seek=3 conv=notrunc 2>/dev/null
args verify a.smb
args disasm a.smb

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: a.smb: refused, because rule 2 is violated at byte 3: its format version is 2
smc: it was made by another version of smc: build it again with this one, from its sources
smc: a.smb: refused, because rule 2 is violated at byte 3: its format version is 2
smc: it was made by another version of smc: build it again with this one, from its sources
-- exit --
0 1 1
