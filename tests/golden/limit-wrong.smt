# Limits are whole numbers, and speak of bytecode.
args build a.sm --max-step=many
args check a.sm --max-ram=0
args build a.sm --emit=c --max-step=9

-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: --max-step requires a whole number from 1, not 'many'
Try 'smc build --help'.
smc: --max-ram requires a whole number from 1, not '0'
Try 'smc check --help'.
smc: --mcu, --max-ram, --max-step and --max-cycles apply to bytecode, not to --emit=c
Try 'smc build --help'.
-- exit --
2 2 2
