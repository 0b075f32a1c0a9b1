spec 2.1   Nor of an element whose type in the state vector is none.
-- app.sv --
[Main]
U64 G
U32 S
float64 p             #! E0351
-- app.sm --
[state_vector]
U64 G
U32 S
F32 p
[Hold]
.step
    p > 5: p = 0
