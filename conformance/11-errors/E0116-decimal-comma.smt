spec 1.12   The decimal point is a point.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[local]
F64 pi = 3,14      #! E0116 write 3.14
[Hold]
.step
    x = 1,5        #! E0116 write 1.5
    p > 2,5: x = pi   #! E0116 write 2.5
    p > 60,000: x = 1       #! E0116 written 60.000, thousands are written 60000
    x = 0,125               #! E0116 write 0.125
    x = 1,234,567           #! E0116 thousands
    x = min(p, 0,5)         #! W0460 written 0.5
