# -MD writes a make rule beside the output.
args build -MD --sv=v.sv a.sm

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
bool open
[Idle]
.step
    open = true
-- file a.d --
a.smb: a.sm v.sv
