spec 5.4  A machine without S is an error.

-- app.sm --
[state_vector]   #! E0209
U64 G
F64 x

[Run]
.step
    x = 1
