spec 5.61, 5.62, 5.65  A definition means its expression in parentheses, where it is used.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
F64 y
F64 z
F64 w
[define]
sum = p + 1
twice = sum * 2
high = (p > 5 or
    x > 100)
[local]
F64 n = 3 * base
F64 again = n + 1
[define]
base = 1 + 1
[Run]
.step
    x = sum * 10
    y = twice
    p = 7
    z = sum
    high: w = again
    sum2: y = 1000
[define]
sum2 = sum > 1000
-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: p = 2
G == 0 {
    @assert x == 30
    @assert y == 6
    @assert z == 8
    @assert w == 7
    @stop
}
