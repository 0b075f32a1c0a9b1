spec 8.29  Files that include each other are an error that names the chain.
expect error

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
include "app.ss"
-- app.ss --
include "b.ss"         #! E0708 b.ss -> app.ss -> b.ss
[options]
delta_t 1
[all_states]
true: @stop
