spec 2.4  True is read as 1 and false as 0.

-- app.sm --
[state_vector]
U64 G
U32 S
bool p
bool q
F64 x

[Run]
.step
    x = p * 10 + q

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    p = 77
    q = 0
    @assert x == 10
    @stop
}
