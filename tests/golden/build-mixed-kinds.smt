# Sources of different kinds are not built in one call.
args build a.sm v.sv

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- v.sv --
[Valves]
bool open
bool drain
[Sensors]
F32 pressure
U64 G
U32 S
-- stderr --
smc: 'a.sm' and 'v.sv' cannot be built in one call; name a state vector with --sv
Try 'smc build --help'.
-- exit --
2
