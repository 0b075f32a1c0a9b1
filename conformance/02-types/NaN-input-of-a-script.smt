spec 2.14  An input that is NaN stores 0.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 d
F32 f
U16 n
bool p
F64 x

[Run]
.step
    x = d + f + n + p

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    d = 5
    d = 0/0    #! W0409
    f = -(0/0)    #! W0409
    n = 0/0    #! W0409
    p = 0/0    #! W0409
    @assert 1 / d == 1/0
    @assert 1 / f == 1/0
    @assert n == 0
    @assert p == 0
    @assert x == 0
    @stop
}
