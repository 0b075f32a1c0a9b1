spec 5.3  A machine without G is an error.

-- app.sm --
[state_vector]   #! E0208
U32 S
F64 x

[Run]
.step
    x = 1
