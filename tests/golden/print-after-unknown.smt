# A pass that does not exist: those that do are named.
args build a.sm --print-after=folding

-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: there is no pass 'folding'; the passes are build, fold, identity, known, simplify_cfg, cse, dse, dce, locals, windows, narrow, if_convert, empty
Try 'smc build --help'.
-- exit --
2
