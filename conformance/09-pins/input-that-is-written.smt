spec 9.13  An input into an element that a machine stores is a warning.

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
i 0 pressure
i 1 limit        #! W1190 machine 'app' writes 'limit', which is an input
i 2 other
[digital]
o 0 open
i 1 open         #! W1190 'open'
