# One machine at a time.
args graph tank.sm tank.sm

-- tank.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: graph accepts one machine at a time
Try 'smc graph --help'.
-- exit --
2
