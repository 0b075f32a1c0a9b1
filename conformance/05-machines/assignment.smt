spec 5.28, 2.13  The value is computed before it is stored, and converted to the type of the variable.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 n
F64 x
bool p

[Run]
.step
    n = n * n - x
    x = x + n
    p = n - 1

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    n = 5
    x = 2.5 + 1
    @assert n == 21
    @assert x == 24.5
    @assert p
    @stop
}
