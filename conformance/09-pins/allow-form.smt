spec 9.13  An @allow without a reason, or with the name of no warning, is an error.

-- app.sv --
[R]
U64 clock
U32 S
F64 pressure
F64 limit
F64 other
bool open
-- app.sm --
[state_vector]
U64 clock @alias G
U32 S
F64 pressure
F64 limit
bool open
[Hold]
.step
    pressure > limit: open = true
    limit = pressure / 2
-- app.io --
[analog]
i 0 limit @allow(two-writers)                  #! E0387
i 1 other @allow(two-writer, "x")              #! E0378 did you mean 'two-writers'?
