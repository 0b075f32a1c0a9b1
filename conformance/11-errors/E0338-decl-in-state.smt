spec 5.9   Variables are declared in [local].

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    F64 y = 3           #! E0338 [local]
    x = p
