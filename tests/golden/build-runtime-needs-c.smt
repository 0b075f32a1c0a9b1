# --runtime says how C is emitted, and nothing of bytecode.
args build --runtime a.sm
-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: --runtime speaks of emitted C: say --emit=c too
Try 'smc build --help'.
-- exit --
2
