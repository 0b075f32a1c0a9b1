spec 1.26   A name follows @ directly.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[local]
F64 a = 3 @ read_only      #! E0117 directly
[Hold]
.step
    x = a
