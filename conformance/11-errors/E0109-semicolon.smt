spec 1.27   A statement ends with its line and has no semicolon.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = 1;              #! E0109 leave it out
    x = 1; x = 2        #! E0109 a statement ends at the end of its line, without ';'
    x = 3
