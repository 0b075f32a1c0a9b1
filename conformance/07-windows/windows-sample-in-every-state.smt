spec 7.4  A window takes its sample at every step, although the state that uses it is not active.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y

[A]
.step
    G == 3: -> B
[B]
.step
    x = roll_avg(p, 4)
    y = roll_max(p, 4)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1
G == 1: p = 2
G == 2: p = 8
G == 3: p = 3
G == 4: p = 4
G == 4: @assert x == 17 / 4 and y == 8
G == 4: @stop
