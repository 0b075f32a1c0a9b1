spec 7.4, 6.4  S is stored before windows sample.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step -> B
[B]
.step x = roll_max(S, 1)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 1: @assert x == 2
G == 1: @stop
