spec 8.1  delta_t is one whole number from 1 to 2^63: 2.5 is an error.

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
delta_t 2.5   #! E0702

[all_states]
G == 3: @stop
