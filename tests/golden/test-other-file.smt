# A file of another kind, whether it exists or not: the message lists the accepted kinds before anything else.
args test a.sm data.csv
args test a.sm nosuch.csv
args test nosuch
args test a.sm a.ss a.sv
args test a.sm cases
args test a.sm
args test a.ss
args test a.sm b.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
[A]
-- b.sm --
-- a.ss --
-- a.sv --
-- data.csv --
1,2
-- cases/x.smt --
-- stderr --
smc: 'data.csv' is not a kind of file that 'smc test' accepts; it accepts a machine (.sm) or an application (.app), state scripts (.ss), requirements (.rq), test cases (.smt) and folders of test cases
Try 'smc test --help'.
smc: 'nosuch.csv' is not a kind of file that 'smc test' accepts; it accepts a machine (.sm) or an application (.app), state scripts (.ss), requirements (.rq), test cases (.smt) and folders of test cases
Try 'smc test --help'.
smc: 'nosuch' is not a kind of file that 'smc test' accepts; it accepts a machine (.sm) or an application (.app), state scripts (.ss), requirements (.rq), test cases (.smt) and folders of test cases
Try 'smc test --help'.
smc: name the state vector with --sv=a.sv
Try 'smc test --help'.
smc: folders contain .smt cases; name scripts one by one, as in 'smc test a.sm SCRIPT.ss'
Try 'smc test --help'.
smc: no script is named to test 'a.sm' with, as in 'smc test a.sm SCRIPT.ss'
Try 'smc test --help'.
smc: no machine is named to run the script on, as in 'smc test MACHINE.sm SCRIPT.ss'
Try 'smc test --help'.
smc: one machine is tested at a time
Try 'smc test --help'.
-- exit --
2 2 2 2 2 2 2 2
