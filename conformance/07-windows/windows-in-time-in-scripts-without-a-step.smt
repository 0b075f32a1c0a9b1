spec 7.24  A delta_t after the window is not known.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
[Run]
.step
    a = p

-- app.ss --
[all_states]
true: p = G
G == 50: @assert roll_max(p, 10 ms) > 10     #! E0411
G == 50: @stop
[options]
delta_t 5
