spec 1.36  A unit is on the line of its number.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 ms = 2
F64 y =
    5
F64 z = (5
    * ms)
[Run]
.step
    x = y
    ms = z
-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: @assert x == 5 and ms == 10
G == 0: @stop
