spec 7.24  A window in time of a script counts with its delta_t.

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
[options]
delta_t 5
[all_states]
true: p = G
G == 50: @assert roll_max(p, 10 ms) - roll_min(p, 10 ms) == 10
G == 50: @stop
