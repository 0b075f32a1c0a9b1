spec 8.22  A script has definitions, and uses those of its machine.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
[define]
high = p > 5
[Run]
.step
    x = high
-- app.ss --
[options]
delta_t 1
[define]
late = G >= 10 and high
mean = roll_avg(p, 2)
unused = 3               #! W0212
[all_states]
true: p = G
late: @assert x == 1
G == 11: @assert mean == 9.5
G == 11: @stop
