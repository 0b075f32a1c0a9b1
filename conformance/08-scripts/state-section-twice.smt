spec 8.4  A section of a state appears once.

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
G == 3: @stop

[A]
true: p = 1

[B]
true: p = 2

[A]   #! E0704
true: p = 3
