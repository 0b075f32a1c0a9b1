# A kind of output that does not exist.
args build --emit=wasm a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: --emit is bytecode, array, c, ir, ast or tokens, not 'wasm'
Try 'smc build --help'.
-- exit --
2
