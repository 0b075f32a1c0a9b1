# The flight runtime takes C, not bytecode.
args build --runtime v.sm

-- v.sm --
[state_vector]
U64 G
U32 S
[A]
-- stderr --
smc: --runtime requires --emit=c
Try 'smc build --help'.
-- exit --
2
