spec 6.2  The first step after starting is the first step of its state: .entry runs, windows contain one sample, locals have their initial values.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 p

[local]
F64 k = 7

[A]
.entry
    x = k
    y = roll_avg(p, 5)
.step
    k = k + 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 4
G == 0: @assert x == 7 and y == 4 and k == 8
G == 1: @assert x == 7 and k == 9
G == 1: @stop
