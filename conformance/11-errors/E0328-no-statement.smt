spec 1.8   Words that form no statement are an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    open the valve      #! E0328 'open'
    x = p
