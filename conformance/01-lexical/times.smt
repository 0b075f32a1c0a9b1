spec 1.36, 1.37  Times in milliseconds, the default unit of G.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x1
F64 x2
F64 x3
F64 x4
F64 x5
F64 x6
F64 x7
F64 x8
[local]
F64 s = 3
F64 ms = 4
F64 limit = 2 min

[Run]
.step
    x1 = 1.5 s
    x2 = 20 ms + 1
    x3 = 250 us
    x4 = 2 h
    x5 = (1_0e-1	min)
    x6 = ms - s + 5
    x7 = limit - 1 s
    x8 = clamp(T, 3 s, 4 s)

-- app.ss --
[options]
delta_t 10 ms

[all_states]
true {
    @assert x1 == 1500
    @assert x2 == 21
    @assert x3 == 0.25
    @assert x4 == 7200000
    @assert x5 == 60000
    @assert x6 == 6
    @assert x7 == 119000
    @assert x8 == 3000
}
G == 0.02 s {
    @assert T == 20 ms
    @stop
}
