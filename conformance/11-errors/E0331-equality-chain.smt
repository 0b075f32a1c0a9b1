spec 3.11   == and != cannot be chained; the message offers two comparisons.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x == p == 3: x = 1      #! E0331 did you mean 'x == p and p == 3'?
    (x == p) == 1: x = 1
    x != p == 3: x = 2      #! E0331 '!=' and '=='
