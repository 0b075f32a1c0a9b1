spec 8.13  In step 1 G is 0.

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
delta_t 7

[all_states]
true: p = p + 1
p == 1: @assert G == 0
p == 2: @assert G == 7
p == 3: @assert G == 14
G == 14: @stop
