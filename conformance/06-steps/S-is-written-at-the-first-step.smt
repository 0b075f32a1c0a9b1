spec 6.4  S changes at the first step of the new state, not at the transition.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[A]
.step
    x = S
    G == 2: -> B
.exit
    y = S * 100

[B]
.entry
    x = S

-- app.ss --
[options]
delta_t 1

[all_states]
G == 2: @assert S == 1 and x == 1 and y == 100
G == 3: @assert S == 2 and x == 2
G == 3: @stop
