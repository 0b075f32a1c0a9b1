spec 5.28   There are no assignments that calculate.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x += 1              #! E0326 x = x + 1
    x *= p              #! E0326 x = x * p
    x *= p + 1          #! E0326 x = x * (...)
    x -= max(p, 1)      #! E0326 x = x - max(p, 1)
    x /= (p) - 1        #! E0326 x = x / (...)
    x++                 #! E0326 '++'
    x--                 #! E0326 '--'
    x = p
