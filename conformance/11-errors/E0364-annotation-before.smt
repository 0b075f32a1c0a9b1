spec 5.1   An annotation follows the name.

-- app.sm --
[state_vector]
@read_only F64 p    #! E0364 '@read_only'
@alias q F64 x      #! E0364 '@alias'
U64 G U32 S
[Hold]
.step
    x = p
