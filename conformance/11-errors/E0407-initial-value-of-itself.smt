spec 5.10   An initial value does not use its own local.
-- app.sm --
[state_vector]
U64 G
U32 S
[local]
F64 x = x + 1                 #! E0407
[Hold]
.step
    x = 1
