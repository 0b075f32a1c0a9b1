spec 8.11  A window of the script is not that of the machine with the same call: the machine samples after the inputs, the script before.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 m

[Run]
.step
    m = roll_max(p, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
true: p = G + 5
G == 2: @assert m == 7 and roll_max(p, 2) == 6
G == 2: @stop
