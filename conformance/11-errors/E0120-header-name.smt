spec 1.23   A section name consists of letters, digits, _ and /.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Tank Vent]     #! E0120 '[Tank Vent]'
.step
    x = p
[ Hold ]        #! E0120 write [Hold]
[]              #! E0120 '[]'
