spec 6.2, 6.7  The same when started in another state.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.entry
    x = 1
[B]
.entry
    x = 2
.step
    x = x + 10

-- app.ss --
[options]
delta_t 1
init_state B

[all_states]
G == 0: @assert x == 12
G == 1: @assert x == 22
G == 1: @stop
