spec 7.4  The sample is the value at the start of the step that uses it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[Run]
.step
    x = roll_max(p, 1)

-- app.ss --
[options]
delta_t 1

[all_states]
true: p = G + 1
true: @assert x == G + 1
G == 3: @stop
