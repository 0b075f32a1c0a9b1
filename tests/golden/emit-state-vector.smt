# A state vector alone gives C.
args build --emit=c v.sv && ls

-- v.sv --
[Valves]
bool open
bool drain
[Sensors]
F32 pressure
U64 G
U32 S
-- stdout --
v.c
v.h
v.sv
