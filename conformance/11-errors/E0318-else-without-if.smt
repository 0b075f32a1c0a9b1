spec 5.36   An else is the next word after its conditional.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    p > 5: x = 1
    x = 2
    else: x = 3         #! E0318 'else'
    x = 4
    p > 5 { x = 1 } x = 2 else { x = 3 }     #! E0330 'else'
