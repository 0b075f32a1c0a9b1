spec 1.12   A text in quotes is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = "open"      #! E0106 write open if
    x == 'a': x = 1   #! E0106 write a if
    x > 3: -> "Hold"    #! E0106 write Hold
