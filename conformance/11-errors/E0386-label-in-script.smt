spec 8.5   A script has no labels.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p
-- app.ss --
[options]
delta_t 10
[Hold]
.step               #! E0386 labels
G == 100: @stop
