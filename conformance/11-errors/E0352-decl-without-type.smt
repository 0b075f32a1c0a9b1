spec 5.1   A declaration has a type.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
flow            #! E0352 F64 flow
[Hold]
.step
    x = p
