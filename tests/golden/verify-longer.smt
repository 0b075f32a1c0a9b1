# Bytes after the end of an image in its file are damage, although a board's slot can contain anything there.
args build a.sm && echo more >>a.smb
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
smc: a.smb: refused, because the image ends at byte 72 and the file at byte 77
smc: data was appended to it, or it is damaged: copy it again, or build it again from its sources
-- exit --
0 1
