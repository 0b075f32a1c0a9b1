spec 5.40  A closing brace without an opening one is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1
    }   #! E0322
