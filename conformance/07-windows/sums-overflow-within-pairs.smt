spec 7.14, 7.12  The overflow of one pair stays, even if the next pair would take it back.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[Run]
.step
    x = roll_avg(p, 4)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1.7e308
G == 2: p = -1.7e308
G == 2: @assert x == 1/0
G == 3: @assert x == 0
G == 3: @stop
