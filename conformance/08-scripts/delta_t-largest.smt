spec 8.1  delta_t may be as large as 2^63.

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
delta_t 9223372036854775808

[all_states]
G > 0: @stop

-- trace --
1 G 0
2 G 9223372036854775808
