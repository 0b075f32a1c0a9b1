spec 8.6  There is no other annotation.

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
G == 0: @demand x == 1   #! E0340
G == 3: @stop
