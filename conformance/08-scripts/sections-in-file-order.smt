spec 8.16  Sections run in the order of the file, [all_states] being nothing special.

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

[A]
true: p = 1

[all_states]
true: p = p * 10 + 2
G == 0: @assert x == 12
G == 0: @stop
