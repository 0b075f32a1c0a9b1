spec 7.4  A window in a branch that is not taken samples too, in .entry and .exit as well.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y
F64 z

[A]
.entry
    G > 0: x = roll_max(p, 3)
.step
    if G == 2: y = roll_max(p, 3)
    G == 3: -> A
.exit
    z = roll_max(p, 3)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 5
G == 1: p = 9
G == 2: p = 1
G == 2: @assert y == 9
G == 3: @assert z == 9
G == 4: @assert x == 1
G == 4: @stop
