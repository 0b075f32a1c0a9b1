spec 2.1  F32 has about 7 digits, F64 about 16.

-- app.sm --
[state_vector]
U64 G
U32 S
F32 f
F64 d

[Run]
.step
    f = 16777217
    d = 16777217

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert f == 16777216
    @assert d == 16777217
    @stop
}
