# A state vector alone; and a machine that does not fit it.
args check v.sv
args check --sv=v.sv a.sm

-- v.sv --
[Valves]
bool open
bool drain
[Sensors]
F32 pressure
U64 G
U32 S
-- a.sm --
[state_vector]
U64 G
U32 S
U8 open
[Idle]
.step
    open = true
-- stderr --
a.sm:4:1: error: element 'open' is bool in the state vector, not U8 [E0206]
    4 | U8 open
      | ^~ write bool
v.sv:2:6: note: 'open' is declared here
1 error
-- exit --
0 1
