# A prefix has to be the beginning of C identifiers, and not one of the runtime's.
args build --emit=c --prefix=2stage a.sm
args build --emit=c --prefix=sm_roll a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: '2stage' cannot be a prefix: a prefix begins with a letter
Try 'smc build --help'.
smc: 'sm_roll' cannot be a prefix: names that begin with sm_, smvm_ and pal_ are the runtime's own
Try 'smc build --help'.
-- exit --
2 2
