spec 1.16   An exponent and 0x need digits.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = 1e          #! E0113 after 'e'
    x = 0x          #! E0113 hexadecimal digit
