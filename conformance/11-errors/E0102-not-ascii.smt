spec 1.1   Outside comments every character is ASCII; the message names a character that looks like one of the language.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p − 1          #! E0102 write -
    x = p ≤ 5          #! E0102 write <=
    x = drück          #! E0102 'ü'
    x = 20°            #! E0102 '°'
    x = p²             #! E0102 '²'
    x = p + 1    #! E0102 plain space
