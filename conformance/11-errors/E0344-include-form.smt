spec 8.27  The name of an included file is written in quotes.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x == 100: -> Vent
[Vent]

-- app.ss --
include plant.ss         #! E0344 include "plant.ss"
include <plant.ss>       #! E0344 include "plant.ss"
import "plant.ss"        #! E0344 include "plant.ss"
[options]
delta_t 1
[all_states]
true: @stop
