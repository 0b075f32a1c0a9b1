# Wrong uses of smc report.
args report
args report a.sm b.sm
args report a.sm --format=pdf
args report a.sm a.sv
args report a.sm --all --time=soon

-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: report requires a machine, as in 'smc report tank.sm'
Try 'smc report --help'.
smc: report accepts one machine at a time
Try 'smc report --help'.
smc: --format is html, text or json, not 'pdf'
Try 'smc report --help'.
smc: 'a.sv' is neither a machine (.sm) nor a script (.ss); name the state vector with --sv
Try 'smc report --help'.
smc: --time requires a whole number from 1, not 'soon'
Try 'smc report --help'.
-- exit --
2 2 2 2 2
