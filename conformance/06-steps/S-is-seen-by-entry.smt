spec 6.4  In .entry S is the number of the new state already.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step -> C
[B]
[C]
.entry x = S

-- app.ss --
[options]
delta_t 1

[all_states]
G == 1: @assert x == 3
G == 1: @stop
