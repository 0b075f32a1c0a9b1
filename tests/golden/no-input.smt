# A command without its inputs.
args build
args check
args test
args explain

-- stderr --
smc: build requires a machine, as in 'smc build tank.sm'
Try 'smc build --help'.
smc: check requires a file, as in 'smc check tank.sm'
Try 'smc check --help'.
smc: name what to test: a machine and a script, as in 'smc test tank.sm tank.ss', or .smt cases
Try 'smc test --help'.
smc: explain requires the code of a diagnostic, as in 'smc explain E0204'
Try 'smc explain --help'.
-- exit --
2 2 2 2
