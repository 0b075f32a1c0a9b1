# A file where the command should stand.
args tank.sm
-- stderr --
smc: a command precedes the file, as in 'smc check tank.sm'
Try 'smc --help'.
-- exit --
2
