spec 8.17  An input is seen by the guards after it, not by those before.

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
p == 5: k = 1
G == 0: p = 5
p == 5: c = 2   #! W0701
G == 0: @assert k == 5 and c == 2
G == 1: @assert k == 1
G == 1: @stop
