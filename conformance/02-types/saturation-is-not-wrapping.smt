spec 2.16  A counter at its end stays there.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 n
I8 m
U32 k

[Run]
.step
    n = n + 1
    m = m - 1
    k = k + 1

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    n = 255
    m = -128
    k = 4294967295
    @assert n == 255
    @assert m == -128
    @assert k == 4294967295
    @stop
}
