spec 2.19  The largest F32 plus half a unit becomes an infinity, a bit less does not.

-- app.sm --
[state_vector]
U64 G
U32 S
F32 a
F32 b
F32 c
F64 x

[Run]
.step
    a = x + 1.0141204801825835e31
    b = x + 1.014e31
    c = -x * 2

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    x = 3.4028234663852886e38
    @assert a == 1/0
    @assert b == x
    @assert c == -1/0
    @stop
}
