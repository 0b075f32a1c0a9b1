spec 3.39  A 0 with a minus sign is to the left of the origin, or below it.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 x

[Run]
.step
    x = atan2(a, b)

-- app.ss --
[options]
delta_t 1
[define]
pi = acos(-1)
[all_states]
G == 0: b = -a
G == 0: @assert x == pi
G == 1: a = -a
G == 1: @assert x == -pi
G == 2: b = -a
G == 2: @assert x == 0 and 1 / x < 0
G == 3: a = 1
G == 3: b = -0 * a
G == 3: @assert x == pi / 2
G == 3: @stop
