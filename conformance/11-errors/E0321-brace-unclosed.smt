spec 5.32   An opening brace needs a closing one in the same block.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    p > 5 {         #! E0321 this '{' has no matching '}'
        x = 1
.exit
    x = 2
[Idle]
.step
    p > 5 {         #! E0321 end of the file
        x = 3
