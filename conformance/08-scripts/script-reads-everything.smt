spec 8.11  A script reads elements, aliases, locals, T, G and S.

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
delta_t 10

[all_states]
G == 0: p = 99
G == 10: p = 3
G == 10: @assert x == 1003 and q == 0 and k == 5 and c == 7 and T == 0 and G == 10 and S == 2
G == 20: @assert T == 10
G == 20: @stop
