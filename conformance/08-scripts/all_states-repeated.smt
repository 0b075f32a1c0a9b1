spec 8.3, 8.16  [all_states] may stand several times; all its conditionals run, in the order of the file.

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
true: p = 1

[A]
true: p = p * 10 + 2

[all_states]
true: p = p * 10 + 3
G == 1: @assert x == 123
G == 1: @stop
