# A machine and a folder, which holds cases but no scripts.
args test a.sm .

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: folders contain .smt cases; name scripts one by one, as in 'smc test a.sm SCRIPT.ss'
Try 'smc test --help'.
-- exit --
2
