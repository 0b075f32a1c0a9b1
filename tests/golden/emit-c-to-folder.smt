# C is called after what -o names: a .c, or the stem of both.  A folder or a device is neither.
args build --emit=c -o made a.sm
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
b.c
b.h
note.txt
-- stderr --
smc: 'made' is a folder: name the .c in it, as in -o made/a.c
Try 'smc build --help'.
smc: 'made/' is a folder: name the .c in it, as in -o made/a.c
Try 'smc build --help'.
smc: C is two files, a .c and a .h: '/dev/null' cannot take both
Try 'smc build --help'.
-- exit --
2 2 2 0 0
