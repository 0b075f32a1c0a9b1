spec 1.12   There are no texts in quotes.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = "open"      #! E0106 quotes
    x == 'a': x = 1   #! E0106 quotes
    x > 3: -> "Hold"    #! E0106 quotes
