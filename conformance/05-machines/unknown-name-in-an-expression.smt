spec 5.20  An undeclared name is an error, and the message offers the nearest declared one.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure
F64 x

[Run]
.step
    x = prssure   #! E0204 pressure
