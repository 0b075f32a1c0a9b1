spec 8.27  Includes precede the first section.

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
[options]
include "b.ss"         #! E0343
delta_t 1
[local]
include "b.ss"         #! E0343
[all_states]
include "b.ss"         #! E0343
true: @stop
