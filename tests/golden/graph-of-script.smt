# A script has no diagram.
args graph tank.ss

-- tank.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: 'tank.ss' is no machine: its name ends in .sm
Try 'smc graph --help'.
-- exit --
2
