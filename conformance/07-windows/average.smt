spec 7.11  The average is the sum divided by the number of samples.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
I16 n

[Run]
.step
    x = roll_avg(p, 4)
    n = roll_avg(p, 4)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 10
G == 1: p = 20
G == 2: p = 40
G == 3: p = 1
G == 0: @assert x == 10
G == 1: @assert x == 15
G == 2: @assert x == 70 / 3 and n == 23
G == 3: @assert x == 71 / 4
G == 3: @stop
