spec 8.27  A file that does not exist, or is no script, cannot be included.

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
include "nosuch.ss"    #! E0707 'nosuch.ss'
include "app.sm"       #! E0707 its name does not end in .ss
include ".ss"          #! E0707
include ""             #! E0707
include "app.ss.ss"    #! E0707 'app.ss.ss'
[options]
delta_t 1
[all_states]
true: @stop
