# Options may stand anywhere, with = or a blank; the last one counts.
args build --emit ir a.sm --emit=c -o b.c && ls

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
b.c
b.h
