spec 5.32   A closing brace needs an opening one.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    p > 5 { x = 1 }
    }                   #! E0322 unmatched '}'
    x = 2
