spec 7.5  The order of the calls in the file does not matter: an inner call in the last state still samples first.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[A]
.step
    x = roll_max(p, 1) + roll_max(roll_max(roll_max(p, 1), 1), 1)

-- app.ss --
[options]
delta_t 1

[all_states]
true: p = G
true: @assert x == 2 * G
G == 3: @stop
