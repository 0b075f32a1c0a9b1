spec 2.7  A guard rounds twice as well.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 x

[Run]
.step
    if a * b - 1 != 0: x = 1
    else: x = 2
    a * b == 1: x = x + 10

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0.1
    b = 10
    @assert x == 12
    @stop
}
