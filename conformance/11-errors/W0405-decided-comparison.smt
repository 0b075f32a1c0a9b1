spec 2.1   A comparison that the type of a variable decides draws a warning.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
U8 x
I8 y
bool b
F64 f
[Hold]
.step
    x > 255: -> Hold          #! W0405 'x' is U8, a whole number from 0 to 255
    y < -128: -> Hold         #! W0405 'y'
    300 == x: -> Hold         #! W0405
    x == 2.5: -> Hold         #! W0414
    b == 2: -> Hold           #! W0405 bool
    0 > x: -> Hold            #! W0405
    f > 3 and 10 < x < 500 < y: -> Hold   #! W0405 'y'
    x >= 0: -> Hold           #! W0406 this is always true: 'x' is U8, a whole number from 0 to 255
    x <= 255: -> Hold         #! W0406
    y != 128: -> Hold         #! W0406
    T >= 0: -> Hold           #! W0406 'T' is U64
    x >= 255: -> Hold
    x > 254: -> Hold
    0 <= x <= 100: -> Hold
    b == 1: -> Hold
    f > 1e300: -> Hold
