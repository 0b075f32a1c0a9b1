spec 6.8  At the first step .entry runs, then .step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.entry
    x = 3
.step
    x = x * 10 + 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 31
G == 1: @assert x == 311
G == 1: @stop
