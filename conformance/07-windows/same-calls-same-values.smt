spec 7.22  Two calls with the same expression and size agree; another size or expression has samples of its own.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y
F64 z
F64 w

[A]
.step
    x = roll_avg(p, 3)
    y = roll_avg(p, 3) - roll_avg((p), 3)
    z = roll_avg(p, 2)
    w = roll_max(p, 3) - roll_max(p + 1, 3)
    G == 2: -> B
[B]
.step
    x = roll_avg(p, 3)

-- app.ss --
[options]
delta_t 1

[all_states]
true: p = G * G
G == 2: @assert x == 5 / 3 and y == 0 and z == 2.5 and w == -1
G == 3: @assert x == 14 / 3
G == 3: @stop
