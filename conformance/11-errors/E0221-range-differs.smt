spec 5.48   Both files must agree on a range.

-- app.sv --
[R]
U64 G
U32 S
F32 x @range 0 40
-- app.sm --
[state_vector]
U64 G
U32 S
F32 x @alias y @range -1 40       #! E0221 'x' has another @range in the state vector file
[A]
.step
    x = 1
