spec 1.21   A line that begins with // and closes a parenthesis of the line above divides; other such lines are comments.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
[Hold]
.step
    x = (y
         // 2)             #! E0108 divide and round down
    x = (y + 1
         // (y + 3))       #! E0108 divide and round down
    x = (y
         // 2 * max(y, 1)) #! E0108 divide and round down
    x = (y
         // the limit      #! E0110 #
         + 3)
    x = max(y,
            // 5) later    #! E0110 #
            3)
    x = (y + 1             #! E0313 end of the line
    x = 3
    // 4)                  #! E0110 #
