spec 2.28, 4.15  The unit of an element comes from the machine, or from the state vector file; a warning shows two that differ.
warn no-all units

-- app.sv --
[R]
U64 G
U32 S
F64 a @unit bar
F64 b @unit bar
F64 c
F64 d @unit kPa
-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b @unit psi         #! W0452 'b' has the unit psi here, but bar
F64 c @unit bar
F64 d @unit J/L

[Run] @safe
.step
    a = c
    b = a                    #! W0448
    c = a
