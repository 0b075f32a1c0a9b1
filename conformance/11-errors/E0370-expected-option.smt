spec 8.1   [options] contains options.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p
-- app.ss --
[options]
delta_t 10
5               #! E0370 the number 5
[all_states]
G == 100: @stop
