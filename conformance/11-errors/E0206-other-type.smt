spec 5.2   When a state vector is given, each listed element must have the same type there.
-- app.sv --
[Main]
U64 G
U32 S
F32 pressure
bool valveOpen
-- app.sm --
[state_vector]
U64 G
U32 S
F64  pressure     #! E0206 element 'pressure' is F32 in the state vector, not F64
bool valveOpen
[Hold]
.step
    valveOpen = pressure > 5
