spec 7.21  The average of inf and −inf is NaN inside its expression: a comparison with it fails, logic reads it as false, and it is stored as 0.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y
F64 z
F64 w

[Run]
.step
    x = roll_avg(p, 2)
    y = roll_avg(p, 2) != roll_avg(p, 2)
    z = roll_avg(p, 2) + 5
    w = not roll_avg(p, 2)
    roll_avg(p, 2) <= 0 or roll_avg(p, 2) >= 0: w = w + 10

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1/0
G == 1: p = -1/0
G == 0: @assert x == 1/0 and y == 0 and z == 1/0 and w == 10
G == 1: @assert x == 0 and y == 1 and z == 0 and w == 1
G == 2: p = 4
G == 3: @assert x == 4 and w == 10
G == 3: @stop

-- trace --
2 x 0x0p+0
2 y 0x1p+0
2 z 0x0p+0
