# An input that is not there is the environment's fault.
args check nowhere.sm

-- stderr --
smc: cannot read 'nowhere.sm': No such file or directory
-- exit --
3
