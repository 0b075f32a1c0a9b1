# A file without mistakes is not changed, and nothing is printed.
args fix app.sm app.ss app.sv --sv app.sv

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x = 1
-- app.ss --
[options]
delta_t 1
[all_states]
G == 2: @stop
-- app.sv --
[A]
U64 G
U32 S
F64 x
