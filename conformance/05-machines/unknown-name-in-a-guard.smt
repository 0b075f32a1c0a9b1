spec 5.20  A name that nobody has declared is an error, and the message offers the nearest one.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure
F64 x

[Run]
.step
    prssure > 5: x = 1   #! E0204 pressure
