spec 1.12  Every form of a decimal number.

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
F64 x9
F64 x10

[Run]
.step
    x1 = 5
    x2 = 7.5
    x3 = .5
    x4 = 5.
    x5 = 1e3
    x6 = 2.5E-3
    x7 = .5e1
    x8 = 5.e+2
    x9 = 0
    x10 = 1E0

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x1 == 10 / 2
    @assert x2 == 15 / 2
    @assert x3 == 1 / 2
    @assert x4 == 10 / 2
    @assert x5 == 10 * 10 * 10
    @assert x6 == 25 / 10000
    @assert x7 == 10 / 2
    @assert x8 == 100 * 5
    @assert x9 == 1 - 1
    @assert x10 == 2 / 2
    @stop
}
