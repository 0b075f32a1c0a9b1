spec 1.37  A time that is too large for an F64 is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1e308 h         #! E0112
    x = 1e300 h
