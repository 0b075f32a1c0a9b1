spec 5.61, 7.22  A window in a definition is the same window at each use.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y
F64 z
[define]
mean = roll_avg(p, 2)
spread = roll_max(mean, 2) - mean
[Run]
.step
    x = mean
    T > 2: -> Next
[Next]
.step
    y = mean
    z = spread
-- app.ss --
[options]
delta_t 1
[all_states]
true: p = G * G
G == 0: @assert x == 0
G == 1: @assert x == 0.5
G == 2: @assert x == 2.5
G == 4: @assert y == 12.5 and z == 0
G == 5: p = 0
G == 5: @assert y == 8 and z == 4.5
G == 5: @stop
