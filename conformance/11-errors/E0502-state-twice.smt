spec 5.18   Two states of one name are an error.
-- app.sm --
[state_vector]
U64 G
U32 S
[Hold]
.step
    -> Hold
[Hold]                        #! E0502 'Hold' is declared here
.step
    x = 1                     #! E0204 'x'
