spec 2.16, 5.11   A constant that does not fit its variable causes a warning.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
U8 x
U8 z
I8 y
I8 w
F32 f
F32 g
bool b
I64 i
[local]
U8 big = 200 + 100 @read_only         #! W0403 'big' is U8 and stores 255 instead of 300
U16 k = 70 @read_only
[Hold]
.step
    x = -1                    #! W0403 stores 0 instead of -1
    y = k * 2                 #! W0403 stores 127 instead of 140
    f = 1e300                 #! W0403 stores inf instead of 1e+300
    g = 0.1
    b = 7
    i = 9223372036854775808
    w = -128
    z = big
