spec 2.15   A constant whose fraction is lost draws a warning.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
U8 x
U8 y
U8 z
F64 f
[Hold]
.step
    x = 2.5                   #! W0404 'x' is U8 and stores 2 instead of 2.5
    y = -0.5                  #! W0404 stores 0 instead of -0.5
    z = 4 / 2
    f = 2.5
