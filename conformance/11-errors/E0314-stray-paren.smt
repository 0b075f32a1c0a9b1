spec 3.8   A closing parenthesis needs an opening one.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = (p + 1))        #! E0314 unmatched ')'
    p > 1): x = 1       #! E0314 unmatched ')'
