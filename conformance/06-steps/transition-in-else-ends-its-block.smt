spec 6.10  The same from an else branch.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[A]
.step
    y = 0
    if G < 1: x = 1
    else if G < 2: -> B
    else: x = 5
    y = 9

[B]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 1 and y == 9
G == 1: @assert x == 1 and y == 0
G == 2: @assert S == 2
G == 2: @stop
