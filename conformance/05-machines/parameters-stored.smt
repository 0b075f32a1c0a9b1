spec 5.79  The ends of a range and the default must be values that the type can store; F32 rounds first.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
[local]
U8  a = 3 @parameter @range 0.5 9             #! E0419 the range of parameter 'a' ends at 0.5, which U8 cannot store
U8  b = 3 @parameter @range 0 256             #! E0419 256, which U8
I8  c = 3 @parameter @range -129 9            #! E0419 -129, which I8
U64 d = 3 @parameter @range 0 18446744073709551616    #! E0419 which U64 cannot store
F32 e = 3 @parameter @range 0 1e39            #! E0419 which F32 cannot store
F32 f = 0.1 @parameter @range 0.1 0.1
U8  g = 3.5 @parameter @range 0 9             #! E0420 the default of parameter 'g' is 3.5: the value of an integer must be a whole number
U8  h = 10 @parameter @range 0 9              #! E0420 the value is above the range
U8  i = 300 @parameter @range 0 255           #! E0420 the value is above the range
F64 j = -0.5 @parameter @range 0 9            #! E0420 the value is below the range
F64 k = 0 / 0 @parameter @range 0 9           #! E0420 the value is not a number
bool l = 2 @parameter                         #! E0420 the value of a bool must be 0 or 1
F32 m = 1e300 @parameter @range 0 9           #! E0420 the value is above the range
I64 n = -9223372036854775808 @parameter @range -9223372036854775808 9223372036854774784
[Run]
.step
    x = a + b + c + d + e + f + g + h + i + j + k + l + m + n
