spec 5.28   A statement begins with a name, an arrow or a condition.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    * x                 #! E0341 '*'
    x = 1
    p > 1: , x = 2      #! E0341 ','
