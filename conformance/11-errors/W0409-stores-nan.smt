spec 2.14   A constant that is NaN draws a warning where it is stored.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
U8 y
[Hold]
.step
    x = sqrt(-1)              #! W0409 'x' stores 0
    y = 0 / 0                 #! W0409 #! W0407
