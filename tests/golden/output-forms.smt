# -o FILE and -oFILE.
args build a.sm -o one.smb
args build a.sm -otwo.smb && cmp one.smb two.smb && ls

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
a.sm
one.smb
two.smb
