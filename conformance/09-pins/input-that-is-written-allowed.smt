spec 9.13  It can be allowed behind the pin.

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
i 1 limit @allow(two-writers, "the machine limits what the pin says")
