spec 5.50, 5.36  An @allow is no part of a conditional: an else cannot follow it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[A]
.step
    x > 2: x = 3
    @allow(dead-code, "x")
    else: x = 4                           #! E0318
