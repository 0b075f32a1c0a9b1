spec 8.4, 8.30  A state has one section in each file.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x == 100: -> Vent
[Vent]

-- b.ss --
[Hold]
true: x = 1
-- app.ss --
include "b.ss"
[options]
delta_t 1
[Hold]
true: x = 2
[Hold]                  #! E0704
true: @stop
