spec 1.11   Words of other languages are named as they are written here.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    IF p > 5: x = 1             #! E0329 write if
    p > 5 AND x > 5: x = 1      #! E0329 write and
    if p > 5 then x = 1         #! E0329 ':'
    elif p > 4: x = 2           #! E0329 else if
    while p > 5 { x = 1 }       #! E0329 no loops
    set x = 3                   #! E0329 leave it out
    x = NOT p                   #! E0329 write not
    p is 3: x = p               #! E0329 write ==
    p is not 3: x = p           #! E0329 write !=
    p IS AT LEAST 3: x = p      #! E0329 write >=
    p is between 3 and 5: x = p #! E0329 compare with ==
    NOT p > 5: x = p            #! E0329 write not (...)
    x = NOT(p)                  #! E0329 write not
    goto Hold                   #! E0329 write ->
