# A code that does not exist.
args explain E0000

-- stderr --
smc: no diagnostic is called 'E0000'; did you mean 'E0101'?
Try 'smc explain --help'.
-- exit --
2
