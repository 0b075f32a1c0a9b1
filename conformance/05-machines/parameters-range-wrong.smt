spec 5.78  Nothing else is reported of a parameter whose range, or what precedes it, is wrong.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 a = 1 @parameter @range 1              #! E0377 expected a number, the highest value of '@range'
F64 b = 1 @parameter @range low high       #! E0377 expected a number, the lowest value of '@range'
F64 c = 1 @parameter @rnage 0 2            #! E0360 did you mean '@range'?
F64 d = 1 @parameter @unit @range 0 2      #! E0440 expected a unit
F64 e = 1 @parameter (0, 2)                #! E0330 expected the end of the line
F64 f = 1 @parameter                       #! E0418 parameter 'f' has no range
[Run]
.step
    x = a + b + c + d + e + f
