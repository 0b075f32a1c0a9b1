spec 2.2  An F64 is read unchanged.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 d
bool p

[Run]
.step
    p = d == 0.1

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    d = 0.1
    @assert p
    @stop
}
