spec 5.1   An element that is listed and never used draws a warning, an input or output that is used does not.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 input
F64 output
F64 idle                      #! W0203 'idle'
[Hold]
.step
    output = input
