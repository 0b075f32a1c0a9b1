spec 5.10  Initial values may use operators, pure functions, chains and earlier locals.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
F64 a = sqrt(16) - 1
bool b = 1 < a <= 3 and not false
F64 c = max(a * b, abs(-11))
F64 d = 1 / a

[Run]
.step
    x = c

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert a == 3
    @assert b == 1
    @assert c == 11
    @assert d == 1/3
    @assert x == 11
    @stop
}
