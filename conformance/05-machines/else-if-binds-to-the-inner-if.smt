spec 5.37, 5.35  An else if too belongs to the innermost open conditional.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 x

[Run]
.step
    if a: if b: x = 1
    else if a: x = 2
    else: x = 3

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    a = 0
    x = 9
}
G == 0: @assert x == 9
G == 1: a = 1
G == 1: @assert x == 2
G == 2: b = 1
G == 2: @assert x == 1
G == 2: @stop
