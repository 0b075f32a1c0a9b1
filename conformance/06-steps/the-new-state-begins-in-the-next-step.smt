spec 6.11  Nothing of the new state runs in the step of the transition.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step -> B
[B]
.entry x = x + 1
.step x = x + 10

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 0
G == 1: @assert x == 11
G == 2: @assert x == 21
G == 2: @stop
