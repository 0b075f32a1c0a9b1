spec 8.28  A file that is included twice counts once, at its first place, and its sections come before those of the files that include it.
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

-- a.ss --
[all_states]
true: x = x * 10 + 1
-- b.ss --
include "a.ss"
[all_states]
true: x = x * 10 + 2
-- app.ss --
include "b.ss"
include "a.ss"
include "b.ss"
[options]
delta_t 1
[all_states]
true: x = x * 10 + 3
true: @assert x == 123
true: @stop
