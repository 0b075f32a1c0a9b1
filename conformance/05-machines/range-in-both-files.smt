spec 5.48  A machine may repeat the range of the state vector file, and may not change it.

-- app.sv --
[R]
U64 G
U32 S
F64 a @range 0 40
F64 b @range 0 40
F64 c @range 0 40
F64 d
F64 e @range -0 1
-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @range 0.0 4e1
F64 b @range 0 41         #! E0221 the range in the state vector file
F64 c
F64 d @range 0 1
F64 e @range 0 1
[A]
.step
    d = a + b + c + e
