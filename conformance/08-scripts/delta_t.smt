spec 8.1, 8.13  G grows by delta_t from step to step.

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
delta_t 250

[all_states]
G == 0: p = 1
G == 250: p = 2
G == 500: @assert x == 2 and T == 500
G == 500: @stop

-- trace --
1 G 0
2 G 250
3 G 500
