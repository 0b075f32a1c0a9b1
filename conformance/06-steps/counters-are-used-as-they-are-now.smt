spec 6.14  A counter that is counted up and then used is used as it is now.

-- app.sm --
[state_vector]
U64 G
U32 S
U16 n
F64 m
F64 k
I32 i
F64 p

[Run]
.step
    if n < 100 {
        n = n + 1
        m = n * 0.5
        k = n + m
    }
    if -100 < i < 100 {
        i = i - 3
        p = i * 2
    }

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    @assert n == 1
    @assert m == 0.5
    @assert k == 1.5
    @assert i == -3
    @assert p == -6
}
G == 1 {
    @assert n == 2
    @assert m == 1
    @assert k == 3
    @assert p == -12
    @stop
}
