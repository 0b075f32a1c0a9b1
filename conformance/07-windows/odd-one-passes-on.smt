spec 7.12  Of three samples the third is added last; of five the fifth, of seven the seventh with the sixth pair.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y
F64 z

[Run]
.step
    x = roll_avg(p, 3)
    y = roll_avg(p, 5)
    z = roll_avg(p, 7)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 0.1
G == 1: p = 0.2
G == 2: p = 0.3
G == 3: p = 0.7
G == 4: p = 0.9
G == 5: p = 1.1
G == 6: p = 1.3
G == 2: @assert x == (0.1 + 0.2 + 0.3) / 3
G == 4: @assert y == ((0.1 + 0.2) + (0.3 + 0.7) + 0.9) / 5
G == 6: @assert z == (((0.1 + 0.2) + (0.3 + 0.7)) + ((0.9 + 1.1) + 1.3)) / 7
G == 6: @stop
