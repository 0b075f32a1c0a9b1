spec 6.9  The .exit that runs belongs to the state that is left.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step -> B
.exit x = 1
[B]
.exit x = 2

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 1
G == 1: @assert x == 1
G == 1: @stop
