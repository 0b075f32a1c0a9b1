spec 1.5   A control character is an error, in comments too.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = 1      #! E0101 0x01
    x = 2 # a  comment   #! E0101 0x02
