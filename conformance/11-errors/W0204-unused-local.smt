spec 5.9   A local that nothing uses draws a warning, a constant too.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 scale = 2 @read_only
F64 limit = scale @read_only
F64 idle  = 1                 #! W0204 'idle'
F64 pi    = 3.14159 @read_only    #! W0204 'pi'
[Hold]
.step
    x > limit: -> Hold
