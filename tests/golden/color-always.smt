# --color=always colours though nothing is a terminal.
args check --color=always a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool valveOpen
[Idle]
.step
    valve0pen = true
-- stderr --
[1ma.sm:7:5: [0m[1;31merror: [0munknown element 'valve0pen' [E0204]
    7 |     valve0pen = true
      |     [1;32m^~~~~~~~~ did you mean 'valveOpen'?[0m
[1ma.sm:4:6: [0m[1;36mnote: [0m'valveOpen' is declared here
1 error
-- exit --
1
