spec 1.2   A comment can contain any text; characters that make it look different cause a warning.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p   # ‮ p = x        #! W0101 U+202E
    x = 1   # אב
