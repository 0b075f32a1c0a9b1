spec 5.21, 5.22  [local] and [state_vector] belong to no state, and can be anywhere before their use.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 k = 1
[A]
.step
    x = k
    -> B
[B]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 1: @assert S == 2 and x == 1
G == 1: @stop
