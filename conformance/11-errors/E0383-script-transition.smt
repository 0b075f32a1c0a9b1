spec 8.7   A script makes no transitions.

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
[all_states]
G == 0: -> Hold     #! E0383 write init_state Hold
G == 100: @stop
