# An -o that ends in '/' or names a folder receives every output under its default name.
args build --emit=c -o made a.sm b.sm && ls made
args build -o made/ a.sm && ls made
args build --emit=c --soft -o soft/ a.sm b.sm && ls soft
args build --emit=array -o array/ a.sm && ls array
args build --emit=ir -o text/ a.sm
args build --emit=ast -o text/ a.sm
args build --emit=tokens -o text/ a.sm && ls text
args build -MD -o rule/ a.sm && cat rule/a.d
args build --emit=c -o same/ a.sm other/a.sm; ls same
args build -o no/where/ a.sm
args build --emit=c -o sources/ note.sm && ls sources

-- made/keep.txt --
-- sources/note.c --
my own
-- other/a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- note.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- b.sm --
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
keep.txt
a.c
a.h
a.smb
b.c
b.h
keep.txt
a.c
a.h
b.c
b.h
sm_soft.c
sm_soft.h
sm_soft_avr.S
a_image.h
a.ast
a.ir
a.tokens
rule/a.smb: a.sm
-- stderr --
smc: 'same/a.c' and 'same/a.c' would be the same file; use another name
Try 'smc build --help'.
ls: cannot access 'same': No such file or directory
smc: cannot create the folder 'no/where/': No such file or directory
smc: 'sources/note.c' exists and was not written by smc; use another name, or --force to replace it
Try 'smc build --help'.
-- exit --
0 0 0 0 0 0 0 0 2 3 2
