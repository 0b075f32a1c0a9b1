# -o - writes to standard output.
args build a.sm
args build a.sm -o - >b.smb && cmp a.smb b.smb

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
