spec 6.10, 6.9  A transition ends its own block, not .exit.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step
    -> B
.exit
    if true: x = 1
    x = x + 10
    if x > 5 { x = x + 100 }
[B]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 111
G == 0: @stop
