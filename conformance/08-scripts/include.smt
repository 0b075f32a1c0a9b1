spec 8.27, 8.28, 8.30  Included files are part of the script: their sections come first, and variables are known in all files.
on   ref vm c

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x == 100: -> Vent
[Vent]

-- lib/plant.ss --
include "../lib/./common.ss"
[local]
F64 level = 2 * start
[Hold]
true: level = level + rate
true: x = level
-- lib/common.ss --
[options]
delta_t 1
[local]
F64 start = 10 @read_only
-- app.ss --
include "lib/common.ss"
include "lib/plant.ss"
[local]
F64 rate = 5
[options]
delta_t 10
[Hold]
x == 30: rate = 70
G == 10: @assert x == 30
[Vent]
G == 30: @assert x == 100 and roll_min(level, 9) == 20
G == 30: @stop
