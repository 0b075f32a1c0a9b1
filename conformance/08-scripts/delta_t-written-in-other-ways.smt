spec 8.1  A whole number can be written in any form.

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
delta_t 2.5e1

[all_states]
G == 50: @stop

-- trace --
2 G 25
3 G 50
