warn self-assignment
-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure @alias p
F64 x
F64 y @read_only
[Hold]
.step
    x = x                     #! W0412 'x'
    pressure = (p)            #! W0412 'pressure'
    x = +x                    #! W0412
    x = -x
    x = x + 0
    p = y
