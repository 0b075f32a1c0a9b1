# A pass that does not exist.
args build --print-after=fodl a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
smc: there is no pass 'fodl'; there are build, fold, identity, simplify_cfg, dce, windows
Try 'smc build --help'.
-- exit --
2
