# The script says where the machine begins; elements begin as zero, locals at their initial values.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
U8 k = 7.9
[First]
[Second]
.entry
    x = k + S
-- app.ss --
[options]
delta_t 1
init_state First
[options]
init_state Second
[First]
true: @assert false
[all_states]
x == 0 and k == 7: @assert x == 9
true: @stop
