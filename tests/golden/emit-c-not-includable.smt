# The emitted C includes its header in quotation marks.
args build a.sm --emit=c -o 'x"y.c'
args build a.sm --emit=c -o 'x\y.c'
args build a.sm --emit=c -o "x'y.c" && ls

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
x'y.c
x'y.h
-- stderr --
smc: emitted C cannot be named 'x"y.c': an #include cannot contain quotation marks or backslashes; choose another name with -o
Try 'smc build --help'.
smc: emitted C cannot be named 'x\y.c': an #include cannot contain quotation marks or backslashes; choose another name with -o
Try 'smc build --help'.
-- exit --
2 2 0
