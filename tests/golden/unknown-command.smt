# An unknown command names the nearest one.
args biuld a.sm

-- stderr --
smc: unknown command 'biuld'; did you mean 'build'?
Try 'smc --help'.
-- exit --
2
