spec 5.42  The same without braces.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step
    -> B
    x = 2   #! W0501

[B]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 1: @assert x == 0 and S == 2
G == 1: @stop
