spec 7.2  A window of 100000 is allowed.
on   ref vm vm-soft c

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[Run]
.step
    x = roll_max(p, 100000)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 9
G == 1: p = 1
G == 50: @assert x == 9
G == 50: @stop
