# -MF, -MT (which may name several targets) and -MP.
args build -MD -MF deps.mk -MT "all the rest" -MP --sv=v.sv a.sm && cat deps.mk && ls

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
-- stdout --
all the rest: a.sm v.sv

a.sm:

v.sv:
a.sm
a.smb
deps.mk
v.sv
