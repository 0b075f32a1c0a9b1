# A prefix has to be the beginning of C identifiers.
args build --emit=c --prefix=2stage a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: '2stage' cannot be a prefix: a prefix begins with a letter
Try 'smc build --help'.
-- exit --
2
