spec 5.1, 1.32   Declarations are not separated by commas.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 y, z        #! E0357 commas
[Hold]
.step
    x = p
