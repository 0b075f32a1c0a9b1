spec 5.29  -> goes to the state named, forward and back.

-- app.sm --
[state_vector]
U64 G
U32 S

[A]
.step
    -> C
[B]
.step
    -> A
[C]
.step
    -> B

-- app.ss --
[options]
delta_t 1

[all_states]
G == 1: @assert S == 3
G == 2: @assert S == 2
G == 3: @assert S == 1
G == 3: @stop
