spec 5.59  A delta_t other than the machine's step is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[options]
step 20 ms

[Run]
.step
    x = T

-- app.ss --
[options]
delta_t 10 ms            #! E0705 delta_t is 10, but the machine declares a step of 20

[all_states]
G == 20: @assert x == 20
G == 20: @stop
