spec 1.37  A time is multiplied exactly and rounded once: 8.004 min is not 8.004 * 60000.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x1
F64 x2
F64 x3
F64 x4
F64 x5

[options]
time_unit us

[Run]
.step
    x1 = 8.004 min
    x2 = 0.1 s
    x3 = 0.1234567890123456789012345678901234567890 s
    x4 = 4.1 ms
    x5 = 1.1 h

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x1 == 480240000
    @assert x2 == 100000
    @assert x3 == 123456.7890123456789
    @assert x4 == 4100
    @assert x5 == 3960000000
    @stop
}
