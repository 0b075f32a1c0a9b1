# Two files cannot go to standard output.
args build --emit=c -o - a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: C is two files, a .c and a .h: standard output cannot take both
Try 'smc build --help'.
-- exit --
2
