# A folder is no source.
args check sub.sm

-- sub.sm/a --
-- stderr --
smc: cannot read 'sub.sm': it is a folder
-- exit --
3
