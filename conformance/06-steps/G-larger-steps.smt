spec 6.3, 6.5  G may grow by any amount from step to step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = x + 1

-- app.ss --
[options]
delta_t 1000000000000000000

[all_states]
G == 3e18: @assert x == 4 and T == 3e18
G == 3e18: @stop
