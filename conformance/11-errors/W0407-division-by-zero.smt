spec 2.9   A division by a value that is always zero causes a warning.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 none = 0 @read_only
F64 some = 0
[Hold]
.step
    x = x / 0                 #! W0407
    x = x / (none * 2)        #! W0407
    x = x / some              #! W0407
    some = 0
