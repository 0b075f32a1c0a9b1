spec 3.17   An element or local cannot be called.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 gain = 2
[Hold]
.step
    x = gain (x - 1)          #! E0218 'gain' is declared here
