spec 5.8   @alias needs a name.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 y @alias        #! E0365 '@alias'
[Hold]
.step
    x = p
