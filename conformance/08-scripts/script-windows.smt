spec 8.11, 8.15  A window of a script samples before the inputs of the step.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 ro @read_only @alias q

[local]
F64 k = 5
F64 c = 7 @read_only

[A]
.step
    x = p
    p == 99: -> B

[B]
.step
    x = p + 1000

-- app.ss --
[options]
delta_t 1

[all_states]
true: p = G + 1
G == 3: @assert roll_max(p, 2) == 3 and roll_min(p, 2) == 2 and roll_avg(p, 4) == (0 + 1 + 2 + 3) / 4
G == 3: @stop
