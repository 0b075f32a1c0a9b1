# An unknown option names the nearest one.
args build --emti=c a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: unknown option '--emti=c'; did you mean '--emit'?
Try 'smc build --help'.
-- exit --
2
