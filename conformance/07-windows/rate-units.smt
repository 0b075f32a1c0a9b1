spec 7.34  In an application in microseconds a second has a million units.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 a
[options]
time_unit us
[Run]
.step
    a = rate(p, 2 steps)

-- app.ss --
[options]
delta_t 500 us
[all_states]
true: p = -G
G == 500: @assert a == -500 / (500 / 1000000)
G == 500: @stop
