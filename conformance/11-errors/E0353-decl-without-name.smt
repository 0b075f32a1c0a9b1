spec 5.1   A declaration has a name.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64             #! E0353 after 'F64'
[Hold]
.step
    x = p
