spec 5.2, 5.20   An element of the state vector that the machine does not list is unknown in it; the message says how to list it.
-- app.sv --
[Main]
U64 G
U32 S
F32 pressure
-- app.sm --
[state_vector]
U64 G
U32 S
[Hold]
.step
    pressure > 5: -> Hold     #! E0204 list it as F32 pressure
