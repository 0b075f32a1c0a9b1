spec 1.9, 8.27  'include' is a name where no text follows.
on   ref vm c

-- app.sm --
[state_vector]
U64 G
U32 S
F64 include
[Hold]
.step
    include = include + 1
-- app.ss --
[options]
delta_t 1
[all_states]
include == 3: @assert include == 4
include > 3: @stop
