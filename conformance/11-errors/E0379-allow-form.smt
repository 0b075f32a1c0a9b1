spec 5.49   An @allow has a name and a reason in parentheses.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @allow                              #! E0379 expected '('
F64 b @allow dead-code "x"                #! E0379 write it as in @allow(dead-code,
F64 c @allow("x")                         #! E0379 expected the name of a warning
F64 d @allow(dead-code "x")               #! E0379 expected a comma
F64 e @allow(dead-code, x)                #! E0379 expected a reason between quotes
F64 f @allow(dead-code, "x"               #! E0379 expected ')'
F64 g @allow(dead-code, "x", "y")         #! E0379 expected ')'
F64 h
[A]
.step
    @allow() h = 1                        #! E0379 expected the name of a warning
    h = a + b + c + d + e + f + g
