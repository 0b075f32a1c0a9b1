spec 5.9   A local has no alias.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[local]
F64 a = 1 @alias b      #! E0362 '@alias'
[Hold]
.step
    x = a + p
