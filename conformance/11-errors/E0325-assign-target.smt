spec 5.28   On the left of = there must be one name.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x + 1 = p           #! E0325 'x + 1'
    5 = x               #! E0325 '5'
