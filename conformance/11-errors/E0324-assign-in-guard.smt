spec 5.30   A guard compares with ==.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    if p = 5: x = 1             #! E0324 write ==
    p = 6: x = 1                #! E0324 write ==
    p > 1 and x = 7 { x = 1 }   #! E0324 write ==
    (p = 8): x = 1              #! E0324 write ==
    x = (p = 9)                 #! E0324 write ==
