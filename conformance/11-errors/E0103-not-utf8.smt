spec 1.2   A byte in a comment that is not UTF-8 is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = 1   # °C          #! E0103 0xB0
