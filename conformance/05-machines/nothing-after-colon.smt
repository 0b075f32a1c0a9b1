spec 5.38  Something must follow the colon before a brace or the end of the file, too.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 a
F64 b

[Run]
.step
    if a { b:   #! E0316
    }
