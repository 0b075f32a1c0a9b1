# An unknown format.
args graph --format=png tank.sm

-- tank.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: --format is svg, dot or mermaid, not 'png'
Try 'smc graph --help'.
-- exit --
2
