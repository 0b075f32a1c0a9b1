# Without -o the output is named after the input and written to the current folder.
args build sub/a.sm && ls

-- sub/a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
a.smb
sub
