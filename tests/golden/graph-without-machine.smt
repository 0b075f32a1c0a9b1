# No machine.
args graph

-- tank.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: graph requires a machine, as in 'smc graph tank.sm'
Try 'smc graph --help'.
-- exit --
2
