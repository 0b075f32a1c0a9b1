# Bytecode in a file called .c is nobody's wish: who means C is told how to ask for it.
args build a.sm -o a.c
-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: 'a.c' is a name for C: add --emit=c for C, or --emit=array for bytecode as a C array
Try 'smc build --help'.
-- exit --
2
