# A file without mistakes is not touched, and nothing is said.
args fix app.sm app.ss app.sv

-- app.sm --
[Hold]
.step
    x = 1
-- app.ss --
[options]
delta_t 1
-- app.sv --
[A]
F64 x
