spec 3.8   An opening parenthesis needs a closing one.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    (p > 5 and x > 5: x = 1     #! E0313 found ':'
    x = p
