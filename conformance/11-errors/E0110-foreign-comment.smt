spec 1.8   A comment begins with # only.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = 1    // open            #! E0110 begin the comment with #
    x = 2    /* one   #! E0110 not with '/*'
     two */
    x = 3
    x = p // x      #! E0110 floor(a / b)
    x = p  // x     #! E0110 floor(a / b)
    x = p  // y     #! E0110 begin the comment with #
    x = 4 // open the valve      #! E0110 begin the comment with #
