spec 6.6, 6.5  Windows see the T of the step they sample in.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = roll_max(T, 10)

-- app.ss --
[options]
delta_t 3

[all_states]
G == 0: @assert x == 0
G == 3: @assert x == 3
G == 6: @assert x == 6
G == 9: @assert x == 9
G == 9: @stop
