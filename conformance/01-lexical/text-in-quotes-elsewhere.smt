spec 1.35  Texts in quotes have no place elsewhere.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @alias "y"                          #! E0106
F64 y
[A] @allow(dead-code, "a reason") "b"     #! E0106
.step
    @allow(dead-code, "a reason") x = "b" #! E0106
    y = max("a", 1)                       #! E0106
