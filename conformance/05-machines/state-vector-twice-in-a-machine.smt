spec 5.9  [state_vector] appears at most once.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[state_vector]   #! E0302
F64 y

[Run]
.step
    x = 1
