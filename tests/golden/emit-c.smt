# --emit=c writes two files.
args build --emit=c a.sm && ls

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
a.c
a.h
a.sm
-- file a.h --
...
AStatus a_step(A *m, ASv *sv);
...
