spec 5.11, 2.6  An initial value is the same as the one a step would calculate.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 a

[local]
F64 p = 0.1 + 0.2 - 0.3
F64 q = sqrt(0.1) / 3 * 7

[Run]
.step
    x = a + 0.2 - 0.3 == p
    y = sqrt(a) / 3 * 7 == q

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    a = 0.1
    @assert x
    @assert y
    @assert p == 5.551115123125783e-17
    @assert q == 0.7378647873726218
    @stop
}
