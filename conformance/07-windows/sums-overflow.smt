spec 7.14  A sum beyond the largest F64 makes the average infinite, though each sample is finite; once the samples have left the window the average is finite again.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x

[Run]
.step
    x = roll_avg(p, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1.7e308
G == 0: @assert x == 1.7e308
G == 1: @assert x == 1/0
G == 2: p = -1.7e308
G == 2: @assert x == 0
G == 3: @assert x == -1/0
G == 4: p = 5
G == 5: @assert x == 5
G == 5: @stop
