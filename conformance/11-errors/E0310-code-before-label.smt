spec 5.25   Statements of a state must be in one of its blocks.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
    x = p       #! E0310 'Hold'
    x = 2
.step
    x = 3
[Idle] the second state     #! E0310 'Idle'
