# C is named after what -o names: a .c, the stem of both files, or their folder. A device is none of these.
args build --emit=c -o made a.sm && ls made
args build --emit=c -o made/ a.sm
args build --emit=c -o /dev/null a.sm
args build --emit=c -o made/a.c a.sm
args build --emit=c -o made/b a.sm && ls made

-- made/note.txt --
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
note.txt
a.c
a.h
b.c
b.h
note.txt
-- stderr --
smc: C is two files, a .c and a .h: '/dev/null' cannot take both
Try 'smc build --help'.
-- exit --
0 0 2 0 0
