spec 1.27   Two statements do not stand on one line, except after }.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    p > 1 { x = 1 } x = 2
    x = 1 x = 2         #! E0330 'x'
    x = p = 3           #! E0330 to compare
    x = 5 bar           #! E0330 units
    x = 5 bar: x = 1    #! E0330 units
