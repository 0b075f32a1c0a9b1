spec 6.1  Without another word a machine starts in state 1.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step
    G == 2: -> B

[B]
.step
    x = S

[C]
.step
    x = 30

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert S == 1
G == 1: @assert S == 1
G == 1: @stop
