spec 5.25   Each label appears at most once in a state.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step        
    x = 1
.exit
    x = p
.step           #! E0309 duplicate '.step'
    x = 2
