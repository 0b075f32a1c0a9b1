spec 6.19  Divisions by zero, overflows and roots of negative numbers do not stop a step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
I8 n
U64 k
F64 z

[Run]
.step
    x = 1 / z
    n = x
    x = sqrt(-1 - z)
    k = -1 / z
    x = roll_avg(1 / z, 3)
    z = z + 0

-- app.ss --
[options]
delta_t 1

[all_states]
true: @assert n == 127 and k == 0 and x == 1/0
G == 2: @stop
