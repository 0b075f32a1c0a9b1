# Half of the smallest difference is 0, a tie that goes to the even side; not half a unit that a sum rounded once could see.
spec 7.16  (b - a) / 2 is rounded before it is added to a.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 median
F64 p

[Run]
.step
    median = roll_median(p, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 15e-324
G == 1: p = 20e-324
G == 2: p = 15e-324
G == 3: @assert median == 15e-324
G == 3: @stop
