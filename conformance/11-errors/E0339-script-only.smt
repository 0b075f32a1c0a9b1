spec 8.6   @assert and @stop belong in a script.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    @assert p > 5       #! E0339 '@assert'
    p > 5: @stop        #! E0339 '@stop'
    x = p
