# An unknown short option is refused.
args build -z a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: unknown option '-z'; did you mean '-o'?
Try 'smc build --help'.
-- exit --
2
