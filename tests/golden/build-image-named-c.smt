# Bytecode in a file called .c is refused; the message names the option that emits C.
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
