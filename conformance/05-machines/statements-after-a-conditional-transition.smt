spec 5.42  A transition under a guard of its own does not make what follows unreachable: no warning.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step
    x > 5: -> B
    x = 9

[B]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 9
G == 2: @assert S == 2
G == 2: @stop
