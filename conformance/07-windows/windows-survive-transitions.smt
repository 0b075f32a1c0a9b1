spec 7.10  A transition does not empty a window.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[A]
.step
    x = roll_max(p, 5)
    -> A

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 9
G == 1: p = 1
G == 4: @assert x == 9
G == 5: @assert x == 1
G == 5: @stop
