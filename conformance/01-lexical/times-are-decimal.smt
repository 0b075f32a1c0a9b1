spec 1.36  A hexadecimal number has no unit, and a unit is on the line of its number.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 0x10 ms    #! E0330
    x = 5 bar      #! E0330 only times have units
    x = 5 seconds  #! E0330 did you mean '5 s'?
