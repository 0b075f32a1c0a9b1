spec 1.14   An underscore that is not between two digits is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = 1_000
    x = 1_          #! E0111 '_'
    x = 1__0        #! E0111 '_'
    x = 1_.5        #! E0111 '_'
    x = 1._5        #! E0111 '_'
    x = 0x1F_       #! E0111 '_'
