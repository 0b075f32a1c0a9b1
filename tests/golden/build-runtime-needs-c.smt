# --runtime says how C is emitted, and nothing of bytecode.
args build --runtime a.sm
-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: --runtime requires --emit=c
Try 'smc build --help'.
-- exit --
2
