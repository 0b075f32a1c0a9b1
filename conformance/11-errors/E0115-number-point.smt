spec 1.12   A number has one decimal point at most.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = 1.2.3      #! E0115 '1.2.3'
    x = 0x1F.8     #! E0115 '0x1F.8'
