spec 5.59, 8.1  A script without delta_t advances by the machine's step.

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
[all_states]
G == 0: @assert x == 0
G == 20: @assert x == 20
G == 40: @assert x == 40
G == 40: @stop

-- same.ss --
[options]
delta_t 20

[all_states]
G == 20: @assert x == 20
G == 20: @stop
