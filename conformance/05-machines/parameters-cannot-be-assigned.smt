spec 5.80  A machine cannot assign a parameter.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
[local]
F64 limit = 1 @parameter @range 0 2
[Run]
.step
    x = limit
    limit = 2                     #! E0417 'limit' cannot be assigned: it is a parameter
