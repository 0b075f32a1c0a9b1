spec 3.18  Elements, locals and states may bear the names of functions.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 max
F64 p @alias abs
F64 y

[local]
F64 roll_avg = 3
F64 sqrt = sqrt(16)

[floor]
.step
    max = max(max, p)
    y = abs + abs(abs) + roll_avg + roll_avg(p, 2) + sqrt
    G == 1: -> min

[min]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = -2
G == 1: p = 4
G == 0: @assert max == 0 and y == -2 + 2 + 3 - 2 + 4
G == 1: @assert max == 4 and y == 4 + 4 + 3 + 1 + 4
G == 2: @assert S == 2
G == 2: @stop
